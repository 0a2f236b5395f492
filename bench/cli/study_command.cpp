#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "study_output.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>

#include <judge/catalogue.hpp>
#include <profile/load.hpp>
#include <study/study.hpp>

namespace gsbench::cli {
namespace {

struct StudyArguments {
  std::string profile;
  study::StudyOptions options;
  std::vector<std::string> within = {"ekf.error=1", "ekf.error=4"};
  bool json = false;
};

Shares parse_shares(const std::vector<std::string>& texts) {
  Shares shares;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string figure = equals == std::string::npos ? "" : text.substr(equals + 1);
    double limit = std::numeric_limits<double>::quiet_NaN();
    if (!CLI::detail::lexical_cast(figure, limit)) {
      limit = std::numeric_limits<double>::quiet_NaN();
    }
    const std::string name = text.substr(0, equals);
    if (!std::isfinite(limit) || judge::find_measure(name) == nullptr) {
      throw profile::ConfigurationError(
          "--within " + text +
          ": write MEASURE=LIMIT, such as ekf.error=4; `gsbench measures` lists them");
    }
    shares.emplace_back(name, limit);
  }
  return shares;
}

int run_study(const StudyArguments& arguments) {
  const Shares shares = parse_shares(arguments.within);
  const profile::Plan plan = profile::load_profile(arguments.profile, judge::measure_names());
  const std::atomic<bool>& interrupted = catch_interrupts();
  study::StudyOptions options = arguments.options;
  options.stop = &interrupted;
  study::StudyResult result;
  {
    Progress progress(plan.name);
    options.progress = [&](std::uint64_t done, std::uint64_t all) {
      progress.show(static_cast<double>(done) / static_cast<double>(all));
    };
    result = study::study(plan, options);
  }
  std::fputs((arguments.json ? study_json(result, shares) : study_table(result, shares)).c_str(),
             stdout);
  return interrupted ? kInterrupted : exit_code_of(result.verdict);
}

}  // namespace

void add_study(CLI::App& app, int& exit_code) {
  auto arguments = std::make_shared<StudyArguments>();
  arguments->options.seeds = 20;
  arguments->options.threads = default_threads();
  CLI::App* command = app.add_subcommand(
      "study", "Run a profile over many seeds on simulated outlets: how its measurements spread");
  command->add_option("profile", arguments->profile, "A shipped profile, or a .toml file")
      ->required();
  command->add_option("--seeds", arguments->options.seeds, "How many")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10000000}))
      ->capture_default_str();
  command->add_option("--first-seed", arguments->options.first_seed, "The first of them")
      ->check(kSeedRange)
      ->capture_default_str();
  command->add_option("--threads", arguments->options.threads, "The result is the same for any")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  command
      ->add_option("--within", arguments->within,
                   "Print the share of a measure within ± a limit: MEASURE=LIMIT")
      ->capture_default_str();
  command->add_flag("--json", arguments->json, "Print as JSON");
  command->footer(
      "Examples:\n"
      "  gsbench study paper/loss-500mw --seeds 200\n"
      "  gsbench study regression/steady --seeds 1000     1000 times the profile's hour");
  command->callback([arguments, &exit_code] { exit_code = run_study(*arguments); });
}

}  // namespace gsbench::cli
