// The output of an emulated instrument, and the clock on which it is defined.
#pragma once

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace gsbench::emulation {

// True time of an emulated station. It counts steps from the moment that the station is set up.
// All emulated devices share it; the clocks of instruments deviate from it by some ppm.
struct TrueTime {
  static constexpr std::int64_t kRate_hz = 64000;  // steps a second

  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();

  std::int64_t now() const { return step_of(std::chrono::steady_clock::now()); }
  std::int64_t step_of(std::chrono::steady_clock::time_point time) const {
    return std::llround(std::chrono::duration<double>(time - start).count() * kRate_hz);
  }
};

class Output {
 public:
  virtual ~Output() = default;
  // Writes the voltage at the instrument's terminals, V: for each of the steps first_step …
  // first_step + count − 1 the mean over the step, so that images of the instrument's own sample
  // rate do not alias. Each call continues where the one before ended. All come from one thread,
  // which is not that of the instrument's commands.
  virtual void render(std::int64_t first_step, std::size_t count, float* volts) = 0;
};

}  // namespace gsbench::emulation
