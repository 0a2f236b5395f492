// How measures are read from one outlet's record.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <judge/case.hpp>

namespace gsbench::judge {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

// What came of one measurement.
struct Reading {
  double value = kNone;
  std::string word = {};     // for measurements that are words
  double uncertainty = 0.0;  // expanded (k = 2), in the measure's unit
  std::string missing = {};  // why there is no value; empty where there is one
  // Where it is missing: the outlet did not do it, or the bench lacks it.
  bool outlets_fault = true;
};

using Read = Reading (*)(const Case&);

// How the measure of this name in the catalogue (measures/catalogue.hpp) is read. Throws
// std::logic_error where bench/judge has no row for it.
Read reading_of(const std::string& measure);

// It is read from the relay sense alone: what the outlet reports plays no part.
bool is_seen(const std::string& measure);

// For those who write measures.
Reading number(double value, double uncertainty = 0.0);
Reading word(std::string text);
Reading not_done(std::string why);   // the outlet did not do it: FAIL where it was expected
Reading not_known(std::string why);  // the bench cannot tell: INCONCLUSIVE
// Milliseconds from a loss to what the outlet stamped after it; `missing`: where it stamped none.
Reading stamped_after(const Case& c, std::int64_t loss_tick, const record::Mark* mark,
                      std::string missing);

// What is read of the first loss that the profile plays.
template <Reading (*kRead)(const Case&, std::int64_t loss_tick)>
Reading after_loss(const Case& c) {
  const auto loss_tick = c.first_loss_tick();
  return loss_tick ? kRead(c, *loss_tick) : not_known("the profile plays no loss");
}

// A row a measure: its name and how it is read, in one file a subject.
using Readings = std::vector<std::pair<std::string, Read>>;
Readings tracker_readings();
Readings event_readings();
Readings estimate_readings();
Readings contact_readings();  // what the relay sense sees without a word of the outlet
Readings relay_readings();
Readings clock_readings();
Readings all_readings();

}  // namespace gsbench::judge
