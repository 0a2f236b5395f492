// Reads the value of a measure from one outlet's record.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <judge/case.hpp>

namespace gsbench::judge {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// Result of one measurement.
struct Reading {
  double value = kNone;
  std::string text = {};     // value of a measure with text values
  double uncertainty = 0.0;  // expanded (k = 2), in the measure's unit
  std::string missing = {};  // why there is no value; empty if there is one
  // True if a missing value is FAIL (the outlet did not act); false if it is INCONCLUSIVE (the
  // bench could not measure).
  bool missing_fails = true;
};

using Read = Reading (*)(const Case&);

// The function that reads the measure of this name (measures/catalogue.hpp). Throws
// std::logic_error if bench/judge has none.
Read reading_of(const std::string& measure);

// Helpers for the functions that read measures.
Reading number(double value, double uncertainty = 0.0);
Reading text(std::string value);
Reading not_done(std::string reason);   // FAIL: the outlet did not do what is measured
Reading not_known(std::string reason);  // INCONCLUSIVE: the bench could not measure it
// Milliseconds from a loss to a mark stamped by the outlet. `missing` is the reason if `mark` is
// null.
Reading stamped_after(const Case& c, std::int64_t loss_tick, const record::Mark* mark,
                      std::string missing);

// Calls kRead with the tick of the first loss in the profile.
template <Reading (*kRead)(const Case&, std::int64_t loss_tick)>
Reading after_loss(const Case& c) {
  const auto loss_tick = c.first_loss_tick();
  return loss_tick ? kRead(c, *loss_tick) : not_known("the profile contains no loss of power");
}

// One row for each measure: its name and the function that reads it.
using Readings = std::vector<std::pair<std::string, Read>>;
Readings tracker_readings();
Readings event_readings();
Readings estimate_readings();
Readings contact_readings();  // need the relay sense only
Readings relay_readings();
Readings clock_readings();
Readings all_readings();

}  // namespace gsbench::judge
