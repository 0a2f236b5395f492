#include "key_figures.hpp"

#include "format.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace gsbench::render {
namespace {

struct KeyMeasure {
  const char* name;        // of the catalogue
  const char* first_line;  // of the heading
  const char* second_line;
};

constexpr std::array kByImportance = {
    KeyMeasure{"event.delay", "Event", "after"},
    KeyMeasure{"decision.delay", "Decision", "after"},
    KeyMeasure{"ekf.loss", "", "ΔP"},
    KeyMeasure{"ekf.error", "ΔP", "error"},
    KeyMeasure{"relay.delay", "Relay", "sensed"},
    KeyMeasure{"relay.delay_reported", "Relay", "reported"},
    KeyMeasure{"relay.report_difference", "Sensed −", "reported"},
    KeyMeasure{"relay.end", "Relay", "at end"},
    KeyMeasure{"trip.time", "Trip", "at"},
    KeyMeasure{"command.delay", "Command", "after"},
    KeyMeasure{"event.false", "False", "events"},
    KeyMeasure{"decision.cause", "", "Cause"},
    KeyMeasure{"tracker.error.max", "Largest", "error"},
    KeyMeasure{"tracker.error.rms", "RMS", "error"},
    KeyMeasure{"validity.valid_share", "", "Valid"},
    KeyMeasure{"validity.dead_bus_claims", "Dead-bus", "claims"},
};

using Results = std::vector<const record::MeasurementResult*>;  // one an outlet; nullptr: none

bool has_value(const record::MeasurementResult* result) {
  return result != nullptr && (!result->text.empty() || !std::isnan(result->value));
}

Results results_of(const Outlets& outlets, const char* measure) {
  Results results;
  for (const record::OutletRecord* outlet : outlets) {
    const record::MeasurementResult* result = find_measurement(*outlet, measure);
    results.push_back(has_value(result) ? result : nullptr);
  }
  return results;
}

// Records of version 6 have no decision.trust among the measurements, but its mark.
bool is_unreliable(const record::OutletRecord& outlet) {
  const record::MeasurementResult* result = find_measurement(outlet, "decision.trust");
  if (has_value(result)) {
    return result->text != "trusted";
  }
  const auto trust =
      std::find_if(outlet.reports.marks.begin(), outlet.reports.marks.end(),
                   [](const record::Mark& mark) { return mark.kind == "decision.trust"; });
  return trust != outlet.reports.marks.end() && trust->value < 0.5;
}

int decimals_of(const Results& results) {
  std::vector<double> values;
  double uncertainty = 0.0;
  for (const record::MeasurementResult* result : results) {
    if (result != nullptr) {
      values.push_back(result->value);
      uncertainty = std::fmax(uncertainty, result->uncertainty);
    }
  }
  return decimals_for(values, uncertainty);
}

// The unit ends the second line: "after, ms"; or is all of it.
std::vector<std::string> heading_of(const KeyMeasure& key, const std::string& unit) {
  const std::string second = key.second_line;
  const std::string separator = second.empty() || unit.empty() ? "" : ", ";
  return {key.first_line, second + separator + unit};
}

KeyColumn column_of(const Outlets& outlets, const KeyMeasure& key, const Results& results) {
  const auto first = std::find_if(results.begin(), results.end(), has_value);
  const std::string unit = (*first)->unit;
  KeyColumn column{key.name, heading_of(key, unit), {}};
  const int decimals = decimals_of(results);
  const bool is_estimate = column.measure.rfind("ekf.", 0) == 0;
  for (std::size_t i = 0; i < results.size(); ++i) {
    const record::MeasurementResult* result = results[i];
    std::string cell = "–";
    if (result != nullptr) {
      cell = !result->text.empty() ? result->text : fixed(result->value, decimals);
      cell = with_unit(cell, result->unit == unit ? "" : result->unit);
      cell += is_estimate && is_unreliable(*outlets[i]) ? " ?" : "";
    }
    column.cells.push_back(cell);
  }
  return column;
}

}  // namespace

std::string KeyColumn::heading_in_one_line() const {
  return heading[0].empty() ? heading[1] : heading[0] + ' ' + heading[1];
}

Outlets outlets_of(const record::RunRecord& run, const std::vector<std::size_t>& indices) {
  Outlets outlets;
  for (const std::size_t index : indices) {
    outlets.push_back(&run.outlets[index]);
  }
  return outlets;
}

std::vector<KeyColumn> key_columns(const Outlets& outlets, std::size_t most) {
  std::vector<KeyColumn> columns;
  for (const KeyMeasure& key : kByImportance) {
    if (columns.size() == most) {
      break;
    }
    const Results results = results_of(outlets, key.name);
    if (std::any_of(results.begin(), results.end(), has_value)) {
      columns.push_back(column_of(outlets, key, results));
    }
  }
  return columns;
}

std::string doubt_note(const Outlets& outlets) {
  const bool any = std::any_of(outlets.begin(), outlets.end(),
                               [](const auto* outlet) { return is_unreliable(*outlet); });
  return any ? "?: an estimate that the outlet flagged as unreliable when it decided" : "";
}

}  // namespace gsbench::render
