#include "commands.hpp"
#include "interrupt.hpp"
#include "progress.hpp"
#include "study_output.hpp"
#include <seed_sweep/seed_sweep.hpp>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <measures/catalogue.hpp>
#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

struct StudyArguments {
  std::string profile;
  seed_sweep::StudyOptions options;
  std::vector<std::string> within;
  bool json = false;
};

// What the paper tells of its estimates; printed where there are any.
const Shares kUsualShares = {{"ekf.error", 1.0}, {"ekf.error", 4.0}};

[[noreturn]] void refuse_share(const std::string& text, const std::string& why) {
  throw profile::ConfigurationError("--within " + text + ": " + why);
}

Shares parse_shares(const std::vector<std::string>& texts) {
  Shares shares;
  for (const std::string& text : texts) {
    const std::size_t equals = text.find('=');
    const std::string figure = equals == std::string::npos ? "" : text.substr(equals + 1);
    char* end = nullptr;
    const double limit = std::strtod(figure.c_str(), &end);
    const bool is_number = !figure.empty() && *end == '\0' && std::isfinite(limit);
    const measures::Measure* measure = measures::find(text.substr(0, equals));
    if (!is_number || measure == nullptr) {
      refuse_share(text, "write MEASURE=LIMIT, such as ekf.error=4; `gsbench measures` lists them");
    }
    if (measure->is_word()) {
      refuse_share(text, measure->name + " is a word, no number");
    }
    if (limit < 0.0) {
      refuse_share(text, "no magnitude is below 0; the limit must be at least 0");
    }
    shares.emplace_back(measure->name, limit);
  }
  return shares;
}

Shares usual_shares(const seed_sweep::StudyResult& study) {
  Shares shares;
  for (const auto& share : kUsualShares) {
    const seed_sweep::Row* row = find_row(study, share.first);
    if (row != nullptr && row->values.count() > 0) {
      shares.push_back(share);
    }
  }
  return shares;
}

int run_study(const StudyArguments& arguments) {
  if (arguments.options.seeds - 1 > profile::kLargestSeed - arguments.options.first_seed) {
    throw profile::ConfigurationError(
        "--first-seed " + std::to_string(arguments.options.first_seed) + " and " +
        std::to_string(arguments.options.seeds) + " seeds go beyond the largest, " +
        std::to_string(profile::kLargestSeed));
  }
  Shares shares = parse_shares(arguments.within);
  const profile::Plan plan = profile::load_profile(arguments.profile);
  const std::atomic<bool>& interrupted = catch_interrupts();
  seed_sweep::StudyOptions options = arguments.options;
  options.stop = &interrupted;
  seed_sweep::StudyResult result;
  {
    Progress progress(plan.name);
    options.progress = [&](std::uint64_t done, std::uint64_t all) {
      progress.show(static_cast<double>(done) / static_cast<double>(all));
    };
    result = seed_sweep::study(plan, options);
  }
  if (shares.empty()) {
    shares = usual_shares(result);
  }
  const std::string text = arguments.json ? study_json(plan, options.first_seed, result, shares)
                                          : study_table(result, shares);
  std::fputs(text.c_str(), stdout);
  return interrupted ? kInterrupted : exit_code_of(result.verdict);
}

}  // namespace

void add_study(CommandLine& line) {
  auto arguments = std::make_shared<StudyArguments>();
  arguments->options.seeds = 20;
  arguments->options.threads = default_threads();
  const Command command = line.command(
      "study", "Run a profile over many seeds on simulated outlets: how its measurements spread");
  command.option("profile", arguments->profile, "A shipped profile, or a .toml file").required();
  command.option("--seeds", arguments->options.seeds, "How many")
      .range(std::uint64_t{1}, std::uint64_t{10000000})
      .show_default();
  command.option("--first-seed", arguments->options.first_seed, "The first of them")
      .range(std::uint64_t{0}, profile::kLargestSeed)
      .show_default();
  command.option("--threads", arguments->options.threads, "The result is the same for any")
      .range(1, 256)
      .show_default();
  command
      .option("--within", arguments->within,
              "MEASURE=LIMIT: print the share of a measure within ± a limit, in the unit that "
              "`gsbench measures` lists; may be given several times; without: ekf.error=1 and "
              "ekf.error=4")
      .one_value_each_time();
  command.flag("--json", arguments->json, "Print as JSON");
  command.footer(
      "Examples:\n"
      "  gsbench study paper/loss-500mw --seeds 200 --within event.delay=140\n"
      "  gsbench study regression/steady --seeds 1000     1000 times the profile's hour");
  command.callback([arguments] { return run_study(*arguments); });
}

}  // namespace gsbench::cli
