// Compares what outlets at several stations measured while the same profile was played to them.
// This shows whether a source plays what the profile states.
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <profile/plan.hpp>
#include <record/run_record.hpp>

namespace gsbench::equivalence {

// NaN: there were no valid reports.
struct Difference {
  double rms = std::numeric_limits<double>::quiet_NaN();
  double largest = std::numeric_limits<double>::quiet_NaN();  // absolute
};

// One outlet at one station. Only valid reports count. A report describes the time of its stamp
// minus the delay that the outlet declares. The outlet measures frequency with its own clock; the
// drift of that clock against the source's, as measured, is subtracted.
struct Row {
  std::size_t run = 0;  // index of its run
  std::string outlet;
  Difference frequency_mhz;  // from the reference
  // From the amplitude in the profile, in per cent of nominal. Reports whose RMS window contains a
  // change of the amplitude do not count.
  Difference voltage_pct;
  // From the first outlet of the first run, whose reports are interpolated linearly. The errors of
  // the outlets' tracker, which are the same at every station, cancel out.
  Difference from_first_mhz;
};

// One row for each outlet that reported, in the order of the runs. All runs played `plan`, or a
// part of its outlets.
std::vector<Row> compare(const profile::Plan& plan, const std::vector<record::RunRecord>& runs);

}  // namespace gsbench::equivalence
