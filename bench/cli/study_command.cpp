#include "commands.hpp"
#include "live_output.hpp"
#include "progress.hpp"
#include <seed_sweep/seed_sweep.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <measures/catalogue.hpp>
#include <render/figures.hpp>
#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;
using seed_sweep::Row;
using seed_sweep::StudyResult;

// Measures and limits, in the unit of the catalogue, for which the share of |value| <= limit is
// printed.
using Shares = std::vector<std::pair<std::string, double>>;

using Quantiles = std::vector<std::pair<const char*, double>>;

const Quantiles kQuantiles = {{"min", 0.0},  {"p1", 0.01},     {"p50", 0.5},
                              {"p99", 0.99}, {"p99.9", 0.999}, {"max", 1.0}};

// Quantiles of the printed table: the first of these lists that fits a line.
const std::vector<Quantiles> kQuantilesOfTable = {
    kQuantiles,
    {{"min", 0.0}, {"p1", 0.01}, {"p50", 0.5}, {"p99", 0.99}, {"max", 1.0}},
    {{"min", 0.0}, {"p50", 0.5}, {"p99", 0.99}, {"max", 1.0}},
    {{"min", 0.0}, {"p50", 0.5}, {"max", 1.0}}};

std::string verdicts_of(const std::map<record::Verdict, std::size_t>& verdicts) {
  std::string text;
  for (const auto& [verdict, count] : verdicts) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, record::to_string(verdict));
  }
  return text;
}

// Empty if nothing was judged.
std::string worst_of(const std::map<record::Verdict, std::size_t>& verdicts) {
  return verdicts.empty() ? "" : record::to_string(verdicts.rbegin()->first);
}

std::string texts_of(const Row& row) {
  std::string text;
  for (const auto& [text_value, count] : row.values.texts()) {
    text += fmt::format("{}{} × {}", text.empty() ? "" : ", ", count, text_value);
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

// nullptr if the study has no such measure.
const Row* find_row(const StudyResult& study, const std::string& measure) {
  const auto row = std::find_if(study.rows.begin(), study.rows.end(),
                                [&](const Row& each) { return each.measure == measure; });
  return row != study.rows.end() ? &*row : nullptr;
}

// Two significant digits.
std::string sigma_text(double sigma) {
  const double unit = sigma > 0.0 ? std::pow(10.0, std::floor(std::log10(sigma)) - 1.0) : 1.0;
  return render::fixed(unit >= 1.0 ? unit * std::round(sigma / unit) : sigma,
                       render::decimals_of_two_digits(sigma));
}

// Decimals of the quantiles: those that the uncertainty supports; without one, at least those of σ,
// unless all values are whole numbers.
int decimals_of(const Row& row) {
  std::vector<double> values;
  for (const auto& [name, p] : kQuantiles) {
    values.push_back(row.values.quantile(p));
  }
  const int decimals = render::decimals_for(values, row.uncertainty);
  const bool all_whole = std::all_of(values.begin(), values.end(), [](double value) {
    return !std::isfinite(value) || value == std::round(value);
  });
  return row.uncertainty > 0.0 || all_whole
             ? decimals
             : std::max(decimals, render::decimals_of_two_digits(row.values.standard_deviation()));
}

// The measure, its unit, the number of values, their quantiles, mean, σ and the verdict. All
// quantiles have the same decimals; the mean has as many as σ if those are more.
std::vector<std::string> cells_of(const Row& row, const Quantiles& quantiles) {
  const seed_sweep::Distribution& values = row.values;
  const int decimals = decimals_of(row);
  const double sigma = values.standard_deviation();
  std::vector<std::string> cells = {row.measure, row.unit, std::to_string(values.count())};
  for (const auto& [name, p] : quantiles) {
    cells.push_back(render::fixed(values.quantile(p), decimals));
  }
  cells.push_back(
      render::fixed(values.mean(), std::max(decimals, render::decimals_of_two_digits(sigma))));
  cells.push_back(sigma_text(sigma));
  cells.push_back(worst_of(row.verdicts));
  return cells;
}

// Lines of the table, a row for each measure that has a number.
std::vector<std::string> number_lines(const StudyResult& study, const Quantiles& quantiles) {
  std::vector<std::vector<std::string>> rows = {{"measure", "unit", "n"}};
  for (const auto& [name, p] : quantiles) {
    rows[0].emplace_back(name);
  }
  rows[0].insert(rows[0].end(), {"mean", "σ", "verdict"});
  for (const Row& row : study.rows) {
    if (row.values.texts().empty()) {
      rows.push_back(cells_of(row, quantiles));
    }
  }
  return render::aligned(rows, "ll" + std::string(quantiles.size() + 3, 'r') + "l");
}

// With as many quantiles as a line holds.
std::vector<std::string> number_table(const StudyResult& study) {
  std::vector<std::string> lines;
  for (const Quantiles& quantiles : kQuantilesOfTable) {
    lines = number_lines(study, quantiles);
    if (render::fit(lines)) {
      break;
    }
  }
  return lines;
}

std::vector<std::string> text_table(const StudyResult& study) {
  std::vector<std::vector<std::string>> rows;
  for (const Row& row : study.rows) {
    if (!row.values.texts().empty()) {
      rows.push_back({row.measure, texts_of(row), worst_of(row.verdicts)});
    }
  }
  return render::aligned(rows, "l");
}

std::string share_text(const StudyResult& study, const std::string& measure, double limit) {
  const Row* row = find_row(study, measure);
  if (row == nullptr || row->values.count() == 0) {
    return fmt::format("|{}| ≤ {:g}: no outlet has a value", measure, limit);
  }
  const std::size_t all = row->values.count() + row->values.missing();
  const double share_pct = 100.0 * row->values.share_within(limit);
  // A step of the share is 100/n percent.
  const int decimals = render::decimals_for({share_pct}, 100.0 / static_cast<double>(all));
  const std::string unit = row->unit.empty() ? "" : ' ' + row->unit;
  return fmt::format("|{}| ≤ {:g}{}: {} % of {}", measure, limit, unit,
                     render::fixed(share_pct, std::max(1, decimals)), all);
}

void print_study(const StudyResult& study, const Shares& shares) {
  for (const std::vector<std::string>& lines : {number_table(study), text_table(study)}) {
    for (const std::string& line : lines) {
      print_wrapped(line, 4);
    }
    if (!lines.empty()) {
      std::puts("");
    }
  }
  for (const Row& row : study.rows) {
    if (row.verdicts.count(record::Verdict::kPass) < row.verdicts.size()) {
      print_wrapped(fmt::format("{}: {}", row.measure, verdicts_of(row.verdicts)), 4);
    }
  }
  for (const auto& [measure, limit] : shares) {
    print_wrapped(share_text(study, measure, limit), 4);
  }
  print_wrapped(fmt::format("{} seeds, {:.2f} outlet-hours; outlets: {}", study.seeds_done,
                            study.hours, verdicts_of(study.verdicts)),
                4);
  if (!study.first_reason.empty()) {
    print_wrapped("First that did not pass: " + study.first_reason, 4);
  }
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

// The shares that the paper states; printed if there are estimates.
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
      refuse_share(text, measure->name + " is a text, not a number");
    }
    if (limit < 0.0) {
      refuse_share(text, "the limit is below 0; it must be at least 0");
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
        std::to_string(arguments.options.seeds) + " seeds exceed the largest seed, " +
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
    print_study(result, shares);
  }
  return interrupted ? kInterrupted : exit_code_of(result.verdict);
}

}  // namespace

void add_study(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "study", "Run a profile with many seeds: the distribution of every measure", run_study);
  arguments.options.seeds = 20;
  add_profile(command, arguments.profile);
  add_with_default(command, "--seeds", arguments.options.seeds, "N",
                   "Number of seeds, 1 to 10 million")
      ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{10000000}));
  add_seed(command, "--first-seed", arguments.options.first_seed, "First seed");
  add_threads(command, arguments.options.threads);
  command
      .add_option(
          "--within", arguments.within,
          "Print the share of the values within ± LIMIT, in the unit that `gsbench measures` "
          "lists; may be given several times (default: ekf.error=1 and ekf.error=4, both in %)")
      ->type_name("MEASURE=LIMIT")
      ->allow_extra_args(false);
  add_json_flag(command, arguments.json);
  command.footer(
      "Only simulated outlets are used.\n"
      "\n"
      "Examples:\n"
      "  gsbench study paper/loss-500mw --seeds 200 --within event.delay=140\n"
      "  gsbench study regression/steady --seeds 1000\n"
      "      1000 seeds of a one-hour profile with two outlets: 2000 outlet-hours");
}

}  // namespace gsbench::cli
