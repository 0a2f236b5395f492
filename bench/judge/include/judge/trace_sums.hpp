// What the measures need of an outlet's traces. It is added up piece by piece, so that a run of any
// length is judged in little memory.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace gsbench::judge {

constexpr double kLongestDelay_s = 0.2;  // of a tracker that is measured

// Of measured − true values, in the measured unit.
struct ErrorSums {
  std::size_t count = 0;
  double largest = 0.0;  // absolute
  double sum = 0.0;
  double squares = 0.0;

  void add(double error);
  double mean() const;
  double rms() const;
};

struct ValidReport {
  double t_s = 0.0;
  double frequency_hz = 0.0;
  double rocof_hz_s = 0.0;
};

struct TraceSums {
  // Of the reports that are marked valid.
  ErrorSums frequency;
  ErrorSums rocof;
  // The first of them during which the reference moves, enough to measure the tracker's delay.
  std::vector<ValidReport> moving;
  std::size_t dead_bus_claims = 0;  // made while the bus is dead

  // Since the tracker has settled.
  std::size_t settled = 0;
  std::size_t settled_valid = 0;

  // By the last estimate until the first decision.
  std::optional<double> loss_instant_s;
};

}  // namespace gsbench::judge
