#include "plot_data.hpp"

#include "format.hpp"
#include "json_text.hpp"
#include "thinning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

// Digits a curve on a screen can show; more only make the file large.
constexpr double kPerHz = 1e5;
constexpr double kPerHz_s = 1e3;
constexpr double kPerMw = 1e2;

Json rounded(double value, double per_unit) {
  return number(std::round(value * per_unit) / per_unit);
}

// Around each mark all reports are drawn: that is where one zooms in.
std::vector<Stretch> around_marks(const record::RunRecord& run,
                                  const std::vector<record::Mark>& marks) {
  const std::int64_t second = run.sample_rate_hz;
  std::vector<Stretch> stretches;
  for (const record::Mark& mark : marks) {
    // A mark within the last stretch only lengthens it: overlapping ones would use up the points.
    const std::int64_t from = mark.tick - second;
    const std::int64_t to = mark.tick + 2 * second;
    if (!stretches.empty() && from >= stretches.back().from_tick &&
        from <= stretches.back().to_tick) {
      stretches.back().to_tick = std::max(stretches.back().to_tick, to);
    } else {
      stretches.push_back({from, to});
    }
  }
  return stretches;
}

Json marks_json(const record::RunRecord& run, const std::vector<record::Mark>& marks) {
  Json list = Json::array();
  for (const record::Mark& mark : marks) {
    // What a decision rested on stands in the tables; one line in the plot is enough.
    const bool detail = mark.kind.rfind("decision.", 0) == 0;
    if (!detail && list.size() < kMostMarks) {
      list.push_back({{"t", seconds(run, mark.tick)},
                      {"kind", valid_text(mark.kind)},
                      {"label", valid_text(mark_label(mark))}});
    }
  }
  return list;
}

Json truth_json(const record::RunRecord& run) {
  Json t = Json::array();
  Json f = Json::array();
  Json r = Json::array();
  const record::TruthTrace& truth = run.truth;
  for (const std::size_t i : thinned(truth.tick, truth.frequency_hz, truth.rocof_hz_s,
                                     around_marks(run, run.stimulus), kMostPoints)) {
    t.push_back(seconds(run, truth.tick[i]));
    f.push_back(rounded(truth.frequency_hz[i], kPerHz));
    r.push_back(rounded(truth.rocof_hz_s[i], kPerHz_s));
  }
  return {{"t", std::move(t)}, {"f", std::move(f)}, {"r", std::move(r)}};
}

Json estimates_json(const record::RunRecord& run, const record::OutletRecord& outlet) {
  Json t = Json::array();
  Json p = Json::array();
  Json trusted = Json::array();
  const record::EstimateTrace& estimates = outlet.estimates;
  for (const std::size_t i : thinned(estimates.tick, estimates.loss_mw, estimates.loss_sigma_mw,
                                     around_marks(run, outlet.marks), kMostPoints)) {
    t.push_back(seconds(run, estimates.tick[i]));
    p.push_back(rounded(static_cast<double>(estimates.loss_mw[i]), kPerMw));
    trusted.push_back(estimates.trusted[i]);
  }
  return {{"t", std::move(t)}, {"p", std::move(p)}, {"trusted", std::move(trusted)}};
}

Json outlet_json(const record::RunRecord& run, const record::OutletRecord& outlet) {
  Json t = Json::array();
  Json f = Json::array();
  Json r = Json::array();
  const record::MeasurementTrace& trace = outlet.trace;
  for (const std::size_t i : thinned(trace.tick, trace.frequency_hz, trace.rocof_hz_s,
                                     around_marks(run, outlet.marks), kMostPoints)) {
    const bool claimed = trace.validity[i] != 0;
    t.push_back(seconds(run, trace.tick[i]));
    f.push_back(claimed ? rounded(static_cast<double>(trace.frequency_hz[i]), kPerHz) : nullptr);
    r.push_back(claimed ? rounded(static_cast<double>(trace.rocof_hz_s[i]), kPerHz_s) : nullptr);
  }
  return {{"id", valid_text(outlet.id)},
          {"t", std::move(t)},
          {"f", std::move(f)},
          {"r", std::move(r)},
          {"e", estimates_json(run, outlet)},
          {"marks", marks_json(run, outlet.marks)}};
}

}  // namespace

std::string mark_label(const record::Mark& mark) {
  static constexpr std::array<std::pair<const char*, const char*>, 9> kLabels = {{
      {"event", "Event"},
      {"lse", "LSE"},
      {"decision", "Decision"},
      {"decision.loss", "ΔP at the decision"},
      {"decision.hits", "Conditions met"},
      {"decision.trust", "Estimate reliable"},
      {"relay.sense", "Relay, sensed"},
      {"relay.word", "Relay, self-reported"},
      {"command", "Command"},
  }};
  for (const auto& [kind, label] : kLabels) {
    if (mark.kind == kind) return label;
  }
  return mark.text.empty() ? mark.kind : mark.text;
}

std::string mark_value(const record::Mark& mark) {
  if (mark.kind == "event") return "";
  if (mark.kind == "relay.word" || mark.kind == "relay.sense") {
    return mark.value != 0.0 ? "closed" : "open";
  }
  const bool power = mark.kind == "lse" || mark.kind == "loss" || mark.kind == "shed" ||
                     mark.kind == "decision" || mark.kind == "decision.loss";
  return with_unit(figure(mark.value), power ? "MW" : "");
}

std::string plot_data(const record::RunRecord& run) {
  Json outlets = Json::array();
  for (const record::OutletRecord& outlet : run.outlets) {
    outlets.push_back(outlet_json(run, outlet));
  }
  const Json data = {{"nominal_hz", run.nominal_hz},
                     {"duration_s", seconds(run, run.duration_ticks)},
                     {"truth", truth_json(run)},
                     {"stimulus", marks_json(run, run.stimulus)},
                     {"outlets", std::move(outlets)}};
  return in_script(data);
}

std::string thinning_note(const record::RunRecord& run) {
  std::size_t longest = 0;
  for (const record::OutletRecord& outlet : run.outlets) {
    longest = std::max(longest, outlet.trace.tick.size());
  }
  if (longest <= kMostPoints) return "";
  return fmt::format(
      "At most {} of up to {} reports per outlet are drawn: all of them around marks, elsewhere "
      "the "
      "extremes of each stretch. The record and the CSV hold them all.",
      kMostPoints, longest);
}

}  // namespace gsbench::render
