#include "manual_page.hpp"

#include "help.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <sstream>

#include <installation/installation.hpp>

namespace gsbench::cli {
namespace {

constexpr const char* kEnvironment[][2] = {
    {"GSBENCH_PROFILES", "Folder of profiles, in place of the shipped ones and the user's own."},
    {"GSBENCH_RUNS", "Folder that contains the runs, in place of the user's own."},
    {"XDG_DATA_HOME", "Where the user's own files are; ~/.local/share by default."},
};

constexpr const char* kFiles[][2] = {
    {"~/.local/share/gsbench/profiles", "The user's own profiles, with grids/ and stations/."},
    {"~/.local/share/gsbench/runs", "The runs that were kept, a folder each."},
};

// Characters that mean something to roff, or that not every terminal shows.
constexpr const char* kReplaced[][2] = {
    {"\\", "\\e"},   {"-", "\\-"},    {"…", "..."},    {"–", "\\-"},    {"×", "\\[mu]"},
    {"Δ", "\\[*D]"}, {"§", "\\[sc]"}, {"σ", "\\[*s]"}, {"≤", "\\[<=]"},
};

std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const auto* found = std::find_if(
        std::begin(kReplaced), std::end(kReplaced),
        [&](const auto& pair) { return text.compare(at, std::strlen(pair[0]), pair[0]) == 0; });
    if (found != std::end(kReplaced)) {
      out += (*found)[1];
      at += std::strlen((*found)[0]);
    } else {
      out += text[at++];
    }
  }
  // A line that begins with a dot or an apostrophe would be a request.
  return !out.empty() && (out.front() == '.' || out.front() == '\'') ? "\\&" + out : out;
}

// Keeps the lines as they are.
std::string verbatim(const std::string& text) {
  std::string out = ".nf\n";
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    out += escaped(line) + '\n';
  }
  return out + ".fi\n";
}

std::string item(const std::string& term, const std::string& text) {
  return ".TP\n" + term + '\n' + escaped(text) + '\n';
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
  return "\\fI" + escaped(text) + "\\fR";
}

std::string positional_name(const CLI::Option& option) {
  const std::string name =
      option.get_name(true, false) + (option.get_items_expected_max() > 1 ? "..." : "");
  return option.get_required() ? name : '[' + name + ']';
}

std::string option_item(const CLI::Option& option) {
  std::string term = option.get_positional() ? italic(option.get_name(true, false))
                                             : bold(option.get_name(false, true));
  if (!option.get_positional() && takes_value(option)) {
    term += ' ' + italic(value_name(option));
  }
  return item(term, description_of(option));
}

std::string command_section(const CLI::App& command) {
  std::string synopsis = bold("gsbench " + command.get_name()) + " [" + italic("OPTIONS") + ']';
  std::string options;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional()) {
      synopsis += ' ' + italic(positional_name(*option));
    }
    options += option == command.get_help_ptr() ? "" : option_item(*option);
  }
  return ".SS " + escaped(command.get_name()) + '\n' + synopsis + "\n.PP\n" +
         escaped(command.get_description()) + '\n' + options + ".PP\n" +
         verbatim(command.get_footer());
}

template <std::size_t count>
std::string list(const char* const (&rows)[count][2]) {
  std::string out;
  for (const auto& row : rows) {
    out += item(bold(row[0]), row[1]);
  }
  return out;
}

}  // namespace

std::string manual_page(const CLI::App& app) {
  std::string page = ".TH GSBENCH 1 \"\" \"gsbench " + installation::version() +
                     "\" \"User Commands\"\n.nh\n.SH NAME\n"
                     "gsbench \\- hardware-in-the-loop bench for frequency-responsive outlets\n"
                     ".SH SYNOPSIS\n" +
                     bold("gsbench") + ' ' + italic("COMMAND") + " [" + italic("OPTIONS") +
                     "]\n.SH DESCRIPTION\n" + verbatim(app.get_description()) +
                     ".SH COMMANDS\nEvery command has \\fB\\-\\-help\\fR.\n";
  for (const CLI::App* command : commands_of(app)) {
    page += command_section(*command);
  }
  return page + ".SH EXIT STATUS\n" + verbatim(app.get_footer()) + ".SH ENVIRONMENT\n" +
         list(kEnvironment) + ".SH FILES\n" + list(kFiles);
}

}  // namespace gsbench::cli
