#include "plot_data.hpp"

#include "format.hpp"
#include "json_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

// Resolution of the curves; more digits would not be visible and only make the file large.
constexpr double kSteps_per_hz = 1e5;
constexpr double kSteps_per_hz_s = 1e3;
constexpr double kSteps_per_mw = 1e2;

Json rounded(double value, double per_unit) {
  return std::round(value * per_unit) / per_unit;
}

// All reports near a mark are drawn, because users zoom in there.
std::vector<Stretch> around_marks(const record::RunRecord& run,
                                  const std::vector<record::Mark>& marks) {
  const std::int64_t second = run.sample_rate_hz;
  std::vector<Stretch> stretches;
  for (const record::Mark& mark : marks) {
    // A mark within the last interval extends it: overlapping intervals would use up the points.
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
    // The values behind a decision are in the tables; the plot has one line for it.
    const bool detail = mark.kind.rfind("decision.", 0) == 0;
    if (!detail && list.size() < kMostMarks) {
      list.push_back({{"t", seconds(run, mark.tick)},
                      {"kind", valid_text(mark.kind)},
                      {"label", valid_text(mark_label(mark))}});
    }
  }
  return list;
}

// For the trace of an outlet or the reference. Invalid reports become gaps.
template <class Value>
Json frequency_json(const record::RunRecord& run, const std::vector<std::int64_t>& tick,
                    const std::vector<Value>& frequency_hz, const std::vector<Value>& rocof_hz_s,
                    const std::vector<record::Mark>& marks,
                    const std::vector<std::uint8_t>& validity) {
  Json t = Json::array();
  Json f = Json::array();
  Json r = Json::array();
  const std::vector<double> frequency(frequency_hz.begin(), frequency_hz.end());
  const std::vector<double> rocof(rocof_hz_s.begin(), rocof_hz_s.end());
  for (const std::size_t i :
       thinned(tick, frequency, rocof, around_marks(run, marks), kMostPoints)) {
    const bool claimed = validity.empty() || validity[i] != 0;
    t.push_back(seconds(run, tick[i]));
    f.push_back(claimed ? rounded(frequency[i], kSteps_per_hz) : nullptr);
    r.push_back(claimed ? rounded(rocof[i], kSteps_per_hz_s) : nullptr);
  }
  return {{"t", std::move(t)}, {"f", std::move(f)}, {"r", std::move(r)}};
}

Json estimates_json(const record::RunRecord& run, const record::OutletRecord& outlet) {
  Json t = Json::array();
  Json p = Json::array();
  Json trusted = Json::array();
  const record::EstimateTrace& estimates = outlet.estimates;
  const std::vector<double> loss_mw(estimates.loss_mw.begin(), estimates.loss_mw.end());
  const std::vector<double> sigma_mw(estimates.loss_sigma_mw.begin(),
                                     estimates.loss_sigma_mw.end());
  for (const std::size_t i :
       thinned(estimates.tick, loss_mw, sigma_mw, around_marks(run, outlet.marks), kMostPoints)) {
    t.push_back(seconds(run, estimates.tick[i]));
    p.push_back(rounded(loss_mw[i], kSteps_per_mw));
    trusted.push_back(estimates.trusted[i]);
  }
  return {{"t", std::move(t)}, {"p", std::move(p)}, {"trusted", std::move(trusted)}};
}

Json outlet_json(const record::RunRecord& run, const record::OutletRecord& outlet) {
  const record::MeasurementTrace& trace = outlet.trace;
  Json json = {{"id", valid_text(outlet.id)}};
  json.update(frequency_json(run, trace.tick, trace.frequency_hz, trace.rocof_hz_s, outlet.marks,
                             trace.validity));
  json["e"] = estimates_json(run, outlet);
  json["marks"] = marks_json(run, outlet.marks);
  return json;
}

}  // namespace

std::string mark_label(const record::Mark& mark) {
  static constexpr std::array<std::pair<const char*, const char*>, 13> kLabels = {{
      {"event", "Event"},
      {"lse", "LSE"},
      {"decision", "Decision"},
      {"decision.loss", "ΔP at the decision"},
      {"decision.sigma", "σ of ΔP"},
      {"decision.nadir", "Predicted nadir without it"},
      {"decision.shed_before", "Shed before"},
      {"decision.hits", "Conditions met"},
      {"decision.trust", "Estimate reliable"},
      {"relay.sense", "Relay, sensed"},
      {"relay.reported", "Relay, self-reported"},
      {"command", "Command"},
      {"settings", "Settings sent, version"},
  }};
  for (const auto& [kind, label] : kLabels) {
    if (mark.kind == kind) {
      return label;
    }
  }
  return mark.text.empty() ? mark.kind : mark.text;
}

std::string mark_value(const record::Mark& mark) {
  if (mark.kind == "event") {
    return "";
  }
  if (mark.kind == "relay.reported" || mark.kind == "relay.sense") {
    return mark.value != 0.0 ? "closed" : "open";
  }
  const bool power = mark.kind == "lse" || mark.kind == "loss" || mark.kind == "shed" ||
                     mark.kind == "ramp end" || mark.kind == "decision" ||
                     mark.kind == "decision.loss" || mark.kind == "decision.sigma" ||
                     mark.kind == "decision.shed_before";
  if (mark.kind == "decision.nadir") {
    return with_unit(fixed(mark.value, 3), "Hz");
  }
  return with_unit(fixed(mark.value, decimals_for({mark.value})), power ? "MW" : "");
}

std::string plot_data(const record::RunRecord& run) {
  const auto each = [&](const record::OutletRecord& outlet) { return outlet_json(run, outlet); };
  return in_script(
      {{"nominal_hz", run.nominal_hz},
       {"duration_s", seconds(run, run.duration_ticks)},
       {"reference", frequency_json(run, run.reference.tick, run.reference.frequency_hz,
                                    run.reference.rocof_hz_s, run.stimulus, {})},
       {"stimulus", marks_json(run, run.stimulus)},
       {"outlets", array_of(run.outlets, each)}});
}

std::string thinning_note(const record::RunRecord& run) {
  std::size_t longest = 0;
  for (const record::OutletRecord& outlet : run.outlets) {
    longest = std::max(longest, outlet.trace.tick.size());
  }
  if (longest <= kMostPoints) {
    return "";
  }
  return fmt::format(
      "At most {} of up to {} reports per outlet are drawn: all reports near marks, elsewhere the "
      "extremes of each interval. The record and the CSV file contain all reports.",
      kMostPoints, longest);
}

}  // namespace gsbench::render
