// The catalogue of measurements: what a profile may set limits to. Each has a name, a unit, a
// definition in one sentence and what it needs; the list is what `gsbench measures` prints.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include <judge/case.hpp>
#include <profile/load.hpp>

namespace gsbench::judge {

// What came of one measurement.
struct Reading {
  double value = std::numeric_limits<double>::quiet_NaN();
  std::string word;          // for measurements that are words
  double uncertainty = 0.0;  // expanded (k = 2), in the measure's unit
  std::string missing;       // why there is no value; empty where there is one
  bool outlets_fault =
      true;  // where it is missing: the outlet did not do it, or the bench lacks it
};

struct Measure {
  std::string name;
  std::string unit;  // empty: a plain number, or a word
  std::string definition;
  std::string needs;
  std::vector<std::string> words;  // not empty: it is one of these
  Reading (*read)(const Case&);

  bool is_word() const { return !words.empty(); }
};

const std::vector<Measure>& catalogue();

// nullptr where there is no such measure.
const Measure* find_measure(const std::string& name);

// Names and units, as a profile is checked against.
profile::MeasureCatalogue measure_names();

// For those who write measures.
Reading number(double value, double uncertainty = 0.0);
Reading word(std::string text);
Reading not_done(std::string why);   // the outlet did not do it: FAIL where it was expected
Reading not_known(std::string why);  // the bench cannot tell: INCONCLUSIVE

// The parts of the catalogue, one file each.
std::vector<Measure> tracker_measures();
std::vector<Measure> event_measures();
std::vector<Measure> estimate_measures();
std::vector<Measure> relay_measures();
std::vector<Measure> clock_measures();

}  // namespace gsbench::judge
