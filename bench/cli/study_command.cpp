#include "commands.hpp"
#include "progress.hpp"
#include <seed_sweep/seed_sweep.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <measures/catalogue.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;
using seed_sweep::Row;
using seed_sweep::StudyResult;

// Shares asked for: of the values of a measure with a magnitude up to a limit, in the catalogue's
// unit.
using Shares = std::vector<std::pair<std::string, double>>;

constexpr std::pair<const char*, double> kQuantiles[] = {
    {"min", 0.0}, {"p1", 0.01}, {"p50", 0.5}, {"p99", 0.99}, {"p99.9", 0.999}, {"max", 1.0}};

std::string figure(double value) {
  return std::isnan(value) ? "–" : fmt::format("{:.4g}", value);
}

std::string verdicts_of(const std::map<record::Verdict, std::size_t>& verdicts) {
  std::string text;
  for (const auto& [verdict, count] : verdicts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, record::to_string(verdict));
  }
  return text;
}

std::string words_of(const Row& row) {
  std::string text;
  for (const auto& [word, count] : row.values.texts()) {
    text += fmt::format("{}{} × {}", text.empty() ? "" : ", ", count, word);
  }
  return text;
}

ordered_json counts(const std::map<record::Verdict, std::size_t>& verdicts) {
  ordered_json out = ordered_json::object();
  for (const auto& [verdict, count] : verdicts) {
    out[record::to_string(verdict)] = count;
  }
  return out;
}

// nullptr where the study has no such measure.
const Row* find_row(const StudyResult& study, const std::string& measure) {
  const auto row = std::find_if(study.rows.begin(), study.rows.end(),
                                [&](const Row& each) { return each.measure == measure; });
  return row != study.rows.end() ? &*row : nullptr;
}

std::string study_table(const StudyResult& study, const Shares& shares) {
  std::string text = fmt::format("{:<26}{:>7}{:>9}", "measure", "unit", "n");
  for (const auto& [name, p] : kQuantiles) {
    text += fmt::format("{:>11}", name);
  }
  text += fmt::format("{:>11}{:>11}  {}\n", "mean", "σ", "judged");
  for (const Row& row : study.rows) {
    text += fmt::format("{:<26}{:>7}", row.measure, row.unit);
    if (!row.values.texts().empty()) {
      text += fmt::format("  {}  {}\n", words_of(row), verdicts_of(row.verdicts));
      continue;
    }
    text += fmt::format("{:>9}", row.values.count());
    for (const auto& [name, p] : kQuantiles) {
      text += fmt::format("{:>11}", figure(row.values.quantile(p)));
    }
    text += fmt::format("{:>11}{:>11}  {}\n", figure(row.values.mean()),
                        figure(row.values.standard_deviation()), verdicts_of(row.verdicts));
  }
  text += "\n";
  for (const auto& [measure, limit] : shares) {
    const Row* row = find_row(study, measure);
    if (row == nullptr || row->values.count() == 0) {
      text += fmt::format("|{}| ≤ {:g}: no outlet has a value\n", measure, limit);
    } else {
      text += fmt::format("|{}| ≤ {:g} {}: {:.3f} % of {}\n", measure, limit, row->unit,
                          100.0 * row->values.share_within(limit),
                          row->values.count() + row->values.missing());
    }
  }
  text += fmt::format("{} seeds, {:.2f} hours of outlets: {}\n", study.seeds_done, study.hours,
                      verdicts_of(study.verdicts));
  if (!study.first_reason.empty()) {
    text += "first that did not pass: " + study.first_reason + "\n";
  }
  return text;
}

ordered_json study_json(const profile::Plan& plan, std::uint64_t first_seed,
                        const StudyResult& study, const Shares& shares) {
  ordered_json out;
  out["profile"] = plan.name;
  out["profile_sha256"] = plan.sha256;
  out["first_seed"] = first_seed;
  out["seeds"] = study.seeds_done;
  out["hours"] = study.hours;
  out["verdict"] = record::to_string(study.verdict);
  out["first_reason"] =
      study.first_reason.empty() ? ordered_json(nullptr) : ordered_json(study.first_reason);
  out["outlets"] = counts(study.verdicts);
  out["measures"] = ordered_json::array();
  for (const Row& row : study.rows) {
    ordered_json entry = {{"name", row.measure}, {"unit", row.unit}};
    if (!row.values.texts().empty()) {
      entry["words"] = row.values.texts();
    } else {
      entry["count"] = row.values.count();
      entry["missing"] = row.values.missing();
      for (const auto& [name, p] : kQuantiles) {
        entry[name] = row.values.quantile(p);
      }
      entry["mean"] = row.values.mean();
      entry["standard_deviation"] = row.values.standard_deviation();
    }
    entry["verdicts"] = counts(row.verdicts);
    out["measures"].push_back(entry);
  }
  out["shares"] = ordered_json::array();
  for (const auto& [measure, limit] : shares) {
    if (const Row* row = find_row(study, measure)) {
      out["shares"].push_back({{"name", measure},
                               {"unit", row->unit},
                               {"within", limit},
                               {"count", row->values.count()},
                               {"share", row->values.share_within(limit)}});
    }
  }
  return out;
}

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
    if (measure->is_text()) {
      refuse_share(text, measure->name + " is a word, no number");
    }
    if (limit < 0.0) {
      refuse_share(text, "no magnitude is below 0; the limit must be at least 0");
    }
    shares.emplace_back(measure->name, limit);
  }
  return shares;
}

Shares usual_shares(const StudyResult& study) {
  Shares shares;
  for (const auto& share : kUsualShares) {
    const Row* row = find_row(study, share.first);
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
  if (arguments.json) {
    print_json(study_json(plan, options.first_seed, result, shares));
  } else {
    std::fputs(study_table(result, shares).c_str(), stdout);
  }
  return interrupted ? kInterrupted : exit_code_of(result.verdict);
}

}  // namespace

void add_study(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "study", "Run a profile over many seeds on simulated outlets: how its measurements spread",
      run_study);
  arguments.options.seeds = 20;
  arguments.options.threads = default_threads();
  command.add_option("profile", arguments.profile, "A shipped profile, or a .toml file")
      ->required();
  add_with_default(command, "--seeds", arguments.options.seeds, "How many")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10000000}));
  add_with_default(command, "--first-seed", arguments.options.first_seed, "The first of them")
      ->check(kSeeds);
  add_with_default(command, "--threads", arguments.options.threads,
                   "The result is the same for any")
      ->check(kThreads);
  command
      .add_option(
          "--within", arguments.within,
          "MEASURE=LIMIT: print the share of a measure within ± a limit, in the unit that `gsbench "
          "measures` lists; may be given several times; without: ekf.error=1 and ekf.error=4")
      ->allow_extra_args(false);
  command.add_flag("--json", arguments.json, "Print as JSON");
  command.footer(
      "Examples:\n"
      "  gsbench study paper/loss-500mw --seeds 200 --within event.delay=140\n"
      "  gsbench study regression/steady --seeds 1000     1000 times the profile's hour");
}

}  // namespace gsbench::cli
