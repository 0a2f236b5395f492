#include "key_figures.hpp"

#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gsbench::render {
namespace {

constexpr std::array kByImportance = {
    KeyFigure{"event.delay", "Event after"},
    KeyFigure{"decision.delay", "Decision after"},
    KeyFigure{"ekf.loss", "ΔP"},
    KeyFigure{"ekf.error", "ΔP error"},
    KeyFigure{"relay.delay", "Relay sensed"},
    KeyFigure{"relay.delay_reported", "Relay reported"},
    KeyFigure{"relay.report_difference", "Difference"},
    KeyFigure{"relay.end", "Relay at end"},
    KeyFigure{"trip.time", "Trip at"},
    KeyFigure{"command.delay", "Command after"},
    KeyFigure{"event.false", "False events"},
    KeyFigure{"decision.cause", "Cause"},
    KeyFigure{"tracker.error.max", "Greatest error"},
    KeyFigure{"tracker.error.rms", "Error, rms"},
    KeyFigure{"validity.valid_share", "Valid"},
    KeyFigure{"validity.dead_bus_claims", "Claims on dead bus"},
};

bool has_value(const record::OutletRecord& outlet, const KeyFigure& key) {
  const record::MeasurementResult* result = find_measurement(outlet, key.measurement);
  return result != nullptr && (!result->text.empty() || !std::isnan(result->value));
}

bool is_unreliable(const record::OutletRecord& outlet) {
  const auto trust =
      std::find_if(outlet.marks.begin(), outlet.marks.end(),
                   [](const record::Mark& mark) { return mark.kind == "decision.trust"; });
  return trust != outlet.marks.end() && trust->value < 0.5;
}

}  // namespace

std::vector<KeyFigure> key_figures(const record::RunRecord& run, std::size_t most) {
  std::vector<KeyFigure> keys;
  for (const KeyFigure& key : kByImportance) {
    if (keys.size() == most) {
      break;
    }
    const bool any = std::any_of(run.outlets.begin(), run.outlets.end(),
                                 [&](const auto& outlet) { return has_value(outlet, key); });
    if (any) {
      keys.push_back(key);
    }
  }
  return keys;
}

std::string key_text(const record::OutletRecord& outlet, const KeyFigure& key) {
  const record::MeasurementResult* result = find_measurement(outlet, key.measurement);
  if (result == nullptr) {
    return "–";
  }
  if (!result->text.empty()) {
    return result->text;
  }
  if (std::isnan(result->value)) {
    return "–";
  }
  // Four digits, and of a small value no more than two.
  const int significant = std::abs(result->value) < 1.0    ? 2
                          : std::abs(result->value) < 10.0 ? 3
                                                           : 4;
  const bool is_estimate = result->name.rfind("ekf.", 0) == 0;
  return with_unit(figure(result->value, significant), result->unit) +
         (is_estimate && is_unreliable(outlet) ? " ?" : "");
}

std::string doubt_note(const record::RunRecord& run) {
  const bool any = std::any_of(run.outlets.begin(), run.outlets.end(), is_unreliable);
  return any ? "?: an estimate that the outlet flagged as unreliable when it decided" : "";
}

}  // namespace gsbench::render
