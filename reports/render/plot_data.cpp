#include "plot_data.hpp"

#include "format.hpp"
#include "html_elements.hpp"
#include "json_text.hpp"
#include "thinning.hpp"

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

constexpr std::size_t kFewestPoints = 100;       // of one curve, if its text is too long
constexpr std::size_t kMostLabel = 80;           // bytes
constexpr std::size_t kMostReference = 150'000;  // bytes

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
                      {"kind", clipped(mark.kind, kMostLabel)},
                      {"label", clipped(mark_label(mark), kMostLabel)}});
    }
  }
  return list;
}

// For the trace of an outlet or the reference. Invalid reports become gaps.
template <class Value>
Json frequency_json(const record::RunRecord& run, const std::vector<std::int64_t>& tick,
                    const std::vector<Value>& frequency_hz, const std::vector<Value>& rocof_hz_s,
                    const std::vector<record::Mark>& marks,
                    const std::vector<std::uint8_t>& validity, std::size_t most) {
  Json t = Json::array();
  Json f = Json::array();
  Json r = Json::array();
  const std::vector<double> frequency(frequency_hz.begin(), frequency_hz.end());
  const std::vector<double> rocof(rocof_hz_s.begin(), rocof_hz_s.end());
  for (const std::size_t i : thinned(tick, frequency, rocof, around_marks(run, marks), most)) {
    const bool claimed = validity.empty() || validity[i] != 0;
    t.push_back(seconds(run, tick[i]));
    f.push_back(claimed ? rounded(frequency[i], kSteps_per_hz) : nullptr);
    r.push_back(claimed ? rounded(rocof[i], kSteps_per_hz_s) : nullptr);
  }
  return {{"t", std::move(t)}, {"f", std::move(f)}, {"r", std::move(r)}};
}

Json estimates_json(const record::RunRecord& run, const record::EstimateTrace& estimates,
                    const std::vector<record::Mark>& marks, std::size_t most) {
  Json t = Json::array();
  Json p = Json::array();
  Json trusted = Json::array();
  const std::vector<double> loss_mw(estimates.loss_mw.begin(), estimates.loss_mw.end());
  const std::vector<double> sigma_mw(estimates.loss_sigma_mw.begin(),
                                     estimates.loss_sigma_mw.end());
  for (const std::size_t i :
       thinned(estimates.tick, loss_mw, sigma_mw, around_marks(run, marks), most)) {
    t.push_back(seconds(run, estimates.tick[i]));
    p.push_back(rounded(loss_mw[i], kSteps_per_mw));
    trusted.push_back(estimates.trusted[i]);
  }
  return {{"t", std::move(t)}, {"p", std::move(p)}, {"trusted", std::move(trusted)}};
}

Json outlet_json(const record::RunRecord& run, const record::OutletRecord& outlet,
                 const record::Reports& kept, std::size_t most) {
  const record::MeasurementTrace& trace = kept.trace;
  Json json = {{"id", clipped(outlet.id, kMostLabel)}};
  json.update(frequency_json(run, trace.tick, trace.frequency_hz, trace.rocof_hz_s,
                             outlet.reports.marks, trace.validity, most));
  json["e"] = estimates_json(run, kept.estimates, outlet.reports.marks, most);
  json["marks"] = marks_json(run, outlet.reports.marks);
  return json;
}

// The text of make(most) with as many points as fit into `most_bytes`.
template <class Make>
std::string fitted(std::size_t most_bytes, const Make& make, std::size_t& most) {
  most = kMostPoints;
  std::string text = in_script(make(most));
  while (text.size() > most_bytes && most > kFewestPoints) {
    most = std::max(kFewestPoints, std::min(most * most_bytes / text.size(), most * 19 / 20));
    text = in_script(make(most));
  }
  return text;
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
    return with_unit(fixed(mark.value, 3), "Hz");
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

std::string mark_note(const record::Mark& mark) {
  if (mark.kind == "event") {
    return "frequency before it";
  }
  const bool is_in_value = mark.text == "MW" || mark.text == "Hz" || mark.text == mark_value(mark);
  return is_in_value ? "" : mark.text;
}

OutletCurves curves_of(const View& view, std::size_t index, const record::OutletRecord& outlet,
                       std::size_t most_bytes) {
  const record::RunRecord& run = view.run;
  const std::vector<Stretch> whole = around_marks(run, outlet.reports.marks);
  using record::EstimateTrace;
  using record::MeasurementTrace;
  TraceThinning<MeasurementTrace> trace(run.duration_ticks, whole, &MeasurementTrace::frequency_hz,
                                        &MeasurementTrace::rocof_hz_s);
  TraceThinning<EstimateTrace> estimates(run.duration_ticks, whole, &EstimateTrace::loss_mw,
                                         &EstimateTrace::loss_sigma_mw);
  view.read_reports(index, [&](const record::Reports& piece) {
    trace.add(piece.trace);
    estimates.add(piece.estimates);
  });
  record::Reports kept;
  kept.trace = trace.take();
  kept.estimates = estimates.take();
  OutletCurves curves{"", trace.entries(), 0};
  curves.json = fitted(
      most_bytes, [&](std::size_t most) { return outlet_json(run, outlet, kept, most); },
      curves.drawn);
  return curves;
}

std::string plot_data(const record::RunRecord& run, const std::vector<OutletCurves>& outlets) {
  std::string text = in_script({{"nominal_hz", run.nominal_hz},
                                {"duration_s", seconds(run, run.duration_ticks)},
                                {"stimulus", marks_json(run, run.stimulus)}});
  text.back() = ',';
  std::size_t drawn = 0;
  const auto reference = [&](std::size_t most) {
    return frequency_json(run, run.reference.tick, run.reference.frequency_hz,
                          run.reference.rocof_hz_s, run.stimulus, {}, most);
  };
  text += "\"reference\":" + fitted(kMostReference, reference, drawn) + ",\"outlets\":[";
  for (const OutletCurves& outlet : outlets) {
    text += (&outlet == &outlets.front() ? "" : ",") + outlet.json;
  }
  return text + "]}";
}

std::string thinning_note(const std::vector<OutletCurves>& outlets) {
  std::size_t longest = 0;
  std::size_t fewest = kMostPoints;
  for (const OutletCurves& outlet : outlets) {
    longest = std::max(longest, outlet.reports);
    fewest = std::min(fewest, outlet.drawn);
  }
  if (longest <= fewest) {
    return "";
  }
  return fmt::format(
      "At most {} of up to {} reports per outlet are drawn: reports near marks, elsewhere the "
      "extremes of each interval. The record has all; `gsbench report RUN --format csv` prints "
      "them.",
      fewest, longest);
}

}  // namespace gsbench::render
