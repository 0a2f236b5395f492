#include "commands.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <map>
#include <thread>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

constexpr std::size_t kMostThreads = 256;
const CLI::Range kSeeds{std::uint64_t{0}, profile::kLargestSeed};
constexpr const char* kSeedRange = "0 to 2^53";

template <class Choice>
void add_choice(CLI::App& command, const std::string& name, Choice& choice,
                const std::map<std::string, Choice>& named, const std::string& text) {
  const auto usual = std::find_if(named.begin(), named.end(),
                                  [&](const auto& entry) { return entry.second == choice; });
  std::string names;
  for (const auto& [choice_name, value] : named) {
    names += (names.empty() ? "" : "|") + choice_name;
  }
  command
      .add_option_function<std::string>(
          name, [&choice, named](const std::string& chosen) { choice = named.at(chosen); }, text)
      ->type_name(names)
      ->check(CLI::IsMember(named))
      ->default_str(usual->first);
}

nlohmann::ordered_json versioned(const nlohmann::ordered_json& object, int format_version) {
  nlohmann::ordered_json out = {{"format_version", format_version}};
  out.update(object);
  return out;
}

}  // namespace

std::size_t default_threads() {
  return std::max(1U, std::thread::hardware_concurrency());
}

ExitCode exit_code_of(record::Verdict verdict) {
  switch (verdict) {
    case record::Verdict::kPass:
      return kPassed;
    case record::Verdict::kInconclusive:
      return kInconclusive;
    case record::Verdict::kFail:
      return kFailed;
    case record::Verdict::kError:
      break;
  }
  return kErrored;
}

void print_json_document(const nlohmann::ordered_json& value) {
  // A file name need not be UTF-8.
  constexpr auto kReplace = nlohmann::ordered_json::error_handler_t::replace;
  std::fputs((value.dump(2, ' ', false, kReplace) + '\n').c_str(), stdout);
}

void print_json(nlohmann::ordered_json value, int format_version) {
  if (!value.is_array()) {
    return print_json_document(versioned(value, format_version));
  }
  for (nlohmann::ordered_json& object : value) {
    object = versioned(object, format_version);
  }
  print_json_document(value);
}

void refuse_empty_values(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    const std::vector<std::string>& values = option->results();
    if (std::find(values.begin(), values.end(), "") != values.end()) {
      throw CLI::ValidationError(option->get_name(), "the value is empty");
    }
  }
}

CLI::Validator number_between(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& text) {
        double value = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, value);
        return is_number && value >= low && value <= high
                   ? std::string()
                   : fmt::format("{} is not a number from {} to {}", text, low, high);
      },
      "");
}

CLI::Option* add_profile(CLI::App& command, std::string& profile) {
  return command.add_option("PROFILE", profile, "Name of a profile, or a .toml file")
      ->type_name("PROFILE")
      ->required();
}

CLI::Option* add_grid(CLI::App& command, std::string& grid) {
  return command.add_option("GRID", grid, "Name of a grid, or a .toml file")->type_name("GRID");
}

CLI::Option* add_seed(CLI::App& command, const std::string& name, std::uint64_t& seed,
                      const std::string& description) {
  return add_with_default(command, name, seed, "N", description + ", " + kSeedRange)->check(kSeeds);
}

CLI::Option* add_seed(CLI::App& command, std::optional<std::uint64_t>& seed,
                      const std::string& description) {
  return command.add_option("--seed", seed, description + ", " + kSeedRange)
      ->type_name("N")
      ->check(kSeeds);
}

void add_threads(CLI::App& command, std::size_t& threads) {
  threads = std::min(default_threads(), kMostThreads);
  // The default is not captured: the manual page is made on another machine than it is read on.
  command
      .add_option("--threads", threads,
                  "Threads, 1 to 256; the result is the same for any number (default: one for each "
                  "processor)")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, kMostThreads));
}

void add_json_flag(CLI::App& command, bool& json) {
  command.add_flag("--json", json, "Print JSON, with all digits");
}

CLI::Option* add_runs_folder(CLI::App& command, std::string& folder) {
  return command
      .add_option("--out", folder,
                  "Folder that contains the runs (default: $GSBENCH_RUNS, else "
                  "~/.local/share/gsbench/runs)")
      ->type_name("FOLDER");
}

void print_wrapped(const std::string& line, std::size_t indent) {
  std::puts(render::wrapped(line, render::kLineColumns, indent).c_str());
}

void print_line(const std::string& line, std::size_t indent) {
  if (isatty(STDOUT_FILENO) == 1) {
    print_wrapped(line, indent);
  } else {
    std::puts(line.c_str());
  }
}

std::string error_line(const std::string& text) {
  constexpr std::size_t kIndent = 4;
  const std::string line = "gsbench: " + text;
  const bool terminal = isatty(STDERR_FILENO) == 1;
  return (terminal ? render::wrapped(line, render::kLineColumns, kIndent) : line) + '\n';
}

void print_error(const std::string& text) {
  std::fputs(error_line(text).c_str(), stderr);
}

void add_noise_distribution(CLI::App& command, campaign::NoiseDistribution& distribution) {
  add_choice(command, "--noise-distribution", distribution,
             {{"uniform", campaign::NoiseDistribution::kUniform},
              {"gaussian", campaign::NoiseDistribution::kGaussian}},
             "Distribution of the noise of measured frequencies");
}

void add_accumulation(CLI::App& command, control_centre::Accumulation& accumulation) {
  add_choice(command, "--accumulated", accumulation,
             {{"half", control_centre::Accumulation::kHalfGroup},
              {"whole", control_centre::Accumulation::kWholeGroup}},
             "Share of an outlet's own load block in its accumulated power P^A; half: the "
             "power shed is on average the power required; whole: eq. (11) as printed");
}

void add_rules(CLI::App& command, control_centre::Rules& rules) {
  add_choice(
      command, "--rules", rules,
      {{"gsbench", control_centre::Rules::kGsbench}, {"paper", control_centre::Rules::kPaper}},
      "Rules by which the control centre derives settings; gsbench: a threshold loss that "
      "allows for the delay of the outlets, switching-off frequencies in stages; paper: "
      "eq. (15) and eq. (17)");
}

void add_loss_instant(CLI::App& command, campaign::LossInstant& instant) {
  add_choice(command, "--loss-instant", instant,
             {{"on-report", campaign::LossInstant::kOnReport},
              {"between-reports", campaign::LossInstant::kBetweenReports}},
             "Instant of the loss; on-report: at the instant of a report, one interval before the "
             "first measurement that is used; between-reports: at random in that interval");
}

}  // namespace gsbench::cli
