#include "study_output.hpp"

#include "json_text.hpp"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;
using seed_sweep::Row;
using seed_sweep::StudyResult;

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
  for (const auto& [word, count] : row.values.words()) {
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

}  // namespace

const Row* find_row(const StudyResult& study, const std::string& measure) {
  for (const Row& row : study.rows) {
    if (row.measure == measure) {
      return &row;
    }
  }
  return nullptr;
}

std::string study_table(const StudyResult& study, const Shares& shares) {
  std::string text = fmt::format("{:<26}{:>7}{:>9}", "measure", "unit", "n");
  for (const auto& [name, p] : kQuantiles) {
    text += fmt::format("{:>11}", name);
  }
  text += fmt::format("{:>11}{:>11}  {}\n", "mean", "σ", "judged");
  for (const Row& row : study.rows) {
    text += fmt::format("{:<26}{:>7}", row.measure, row.unit);
    if (!row.values.words().empty()) {
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

std::string study_json(const profile::Plan& plan, std::uint64_t first_seed,
                       const StudyResult& study, const Shares& shares) {
  const auto finite_or_null = [](double value) {
    return std::isfinite(value) ? ordered_json(value) : ordered_json(nullptr);
  };
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
    if (!row.values.words().empty()) {
      entry["words"] = row.values.words();
    } else {
      entry["count"] = row.values.count();
      entry["missing"] = row.values.missing();
      for (const auto& [name, p] : kQuantiles) {
        entry[name] = finite_or_null(row.values.quantile(p));
      }
      entry["mean"] = finite_or_null(row.values.mean());
      entry["standard_deviation"] = finite_or_null(row.values.standard_deviation());
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
                               {"share", finite_or_null(row->values.share_within(limit))}});
    }
  }
  return json_text(out);
}

}  // namespace gsbench::cli
