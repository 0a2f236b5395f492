#include "completion.hpp"

#include "help.hpp"
#include "run_folder.hpp"

#include <algorithm>
#include <exception>
#include <sstream>

#include <paper/reproduction.hpp>
#include <profile/files.hpp>

namespace gsbench::cli {
namespace {

using Words = std::vector<std::string>;

Words section_ids() {
  Words ids;
  for (const paper::Item& section : paper::items()) {
    ids.push_back(section.id);
  }
  return ids;
}

Words run_ids() {
  Words ids;
  for (const std::string& record : list_records(default_runs_folder())) {
    ids.push_back(std::filesystem::path(record).parent_path().filename().string());
  }
  return ids;
}

// The values of "{a,b,c}", which is how CLI11 describes a fixed set.
Words fixed_set(const std::string& type) {
  Words values;
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open);
  if (open != std::string::npos && close != std::string::npos) {
    std::istringstream list(type.substr(open + 1, close - open - 1));
    for (std::string value; std::getline(list, value, ',');) {
      values.push_back(value);
    }
  }
  return values;
}

Words values_of(const CLI::Option& option) {
  const std::string name = value_name(option);
  if (name == "PROFILE") {
    return names_of(profile::all_profiles());
  }
  if (name == "GRID") {
    return names_of(profile::all_grids());
  }
  if (name == "STATION") {
    return names_of(profile::all_stations());
  }
  if (name == "SECTION,…") {
    return section_ids();
  }
  return name == "RUN" ? run_ids() : fixed_set(option.get_type_name());
}

// Those of `candidates` that `word` is the beginning of.
Words beginning_with(const std::string& word, Words candidates) {
  candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                  [&](const std::string& candidate) {
                                    return candidate.compare(0, word.size(), word) != 0;
                                  }),
                   candidates.end());
  return candidates;
}

Words option_names(const CLI::App& command) {
  Words names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

// For an option that takes a list, "a,b" completes its last value.
Words completed_value(const CLI::Option& option, const std::string& word) {
  const std::size_t comma =
      option.get_delimiter() != '\0' ? word.rfind(option.get_delimiter()) : std::string::npos;
  const std::string before = comma == std::string::npos ? "" : word.substr(0, comma + 1);
  Words values = beginning_with(word.substr(before.size()), values_of(option));
  for (std::string& value : values) {
    value.insert(0, before);
  }
  return values;
}

// `words`: those after the command, the last one to be completed.
Words complete_arguments(const CLI::App& command, const Words& words) {
  const CLI::Option* awaited = nullptr;  // the option whose value comes next
  std::size_t positionals = 0;
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (awaited != nullptr) {
      awaited = nullptr;
    } else if (words[i].size() > 1 && words[i].front() == '-') {
      const CLI::Option* option = command.get_option_no_throw(words[i]);
      awaited = option != nullptr && takes_value(*option) ? option : nullptr;
    } else {
      ++positionals;
    }
  }
  const std::string& word = words.back();
  if (awaited != nullptr) {
    return completed_value(*awaited, word);
  }
  if (!word.empty() && word.front() == '-') {
    return beginning_with(word, option_names(command));
  }
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      if (positionals == 0 || option->get_items_expected_max() > 1) {
        return completed_value(*option, word);
      }
      --positionals;
    }
  }
  return {};
}

// bash splits "--station=x" at the "="; other shells do not.
Words without_equals_signs(const Words& words) {
  Words split;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::size_t equals = words[i].find('=');
    if (words[i] == "=") {
      if (i + 1 == words.size()) {
        split.emplace_back();
      }
    } else if (words[i].compare(0, 2, "--") == 0 && equals != std::string::npos) {
      split.push_back(words[i].substr(0, equals));
      split.push_back(words[i].substr(equals + 1));
    } else {
      split.push_back(words[i]);
    }
  }
  return split;
}

}  // namespace

Words completions(const CLI::App& app, Words words) {
  words = without_equals_signs(words);
  if (words.empty()) {
    words.emplace_back();
  }
  if (words.size() > 1) {
    const auto named =
        app.get_subcommands([&](const CLI::App* command) { return command->check_name(words[0]); });
    if (named.empty()) {
      return {};
    }
    try {
      return complete_arguments(*named.front(), {words.begin() + 1, words.end()});
    } catch (const std::exception&) {
      return {};  // for instance no folder of profiles: there is nothing to offer
    }
  }
  Words candidates = command_names(app);
  const Words options = option_names(app);
  candidates.insert(candidates.end(), options.begin(), options.end());
  return beginning_with(words[0], candidates);
}

}  // namespace gsbench::cli
