// The time between energising and the start of the stimulus: nominal voltage is held while outlets
// boot and join.
#pragma once

#include <chrono>
#include <cstddef>
#include <vector>

#include <drivers/result.hpp>
#include <station/run.hpp>
#include <station/station.hpp>

namespace gsbench::station {

class Boot {
 public:
  // Begins now: the source has just been energised.
  Boot(Station& station, const std::vector<Slot>& slots, const RunOptions& options);

  // Holds the voltage and shows the wait. Must be called at least every 50 ms. An error if the
  // source fails or the run is to stop.
  drivers::Status hold(std::size_t joined);
  // The same, but throws BenchFault and Stopped.
  void keep_up(std::size_t joined);
  // Holds the voltage to the end of the boot time, if something needs all of it. Throws BenchFault
  // and Stopped.
  void finish();

 private:
  double left_s() const;

  Station& station_;
  const RunOptions& options_;
  std::size_t linked_ = 0;
  bool needs_all_ = false;
  std::chrono::steady_clock::time_point end_;
};

}  // namespace gsbench::station
