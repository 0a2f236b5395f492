// Times of a run.
#pragma once

#include <keys/key.hpp>

namespace gsbench::profile {

// A run's records are held in memory, 130 MB an outlet for this long; longer times are studied over
// many seeds.
constexpr double kLongestRun_s = 1.0e5;
// An outlet has 96 ms to answer to its settings.
constexpr double kShortestRun_s = 0.1;

// at_s: an instant before the end of the run.
keys::Key time_in_run(const char* meaning);
keys::Range within_run(double duration_s);

}  // namespace gsbench::profile
