// What plays the mains voltage: simulated, or an instrument. One source feeds all outlets of a run.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include <drivers/result.hpp>

namespace gsbench::source {

struct SourceInfo {
  std::string name;               // "simulated", or maker and model
  double full_scale_pu = 0.0;     // largest voltage it can play, per unit of nominal peak
  bool noise_per_outlet = false;  // each outlet gets noise of its own; else all get the same
};

struct SourceSettings {
  std::int64_t sample_rate_hz = 0;
  int nominal_hz = 50;
  float noise_rms_pu = 0.0F;  // white, added by the source, per unit of nominal peak
  std::uint64_t seed = 0;     // of that noise
};

class Source {
 public:
  virtual ~Source() = default;
  virtual SourceInfo info() const = 0;
  [[nodiscard]] virtual drivers::Status start(const SourceSettings& settings) = 0;

  // Plays samples first_tick … first_tick + count − 1, per unit of nominal peak; ticks follow on
  // one another. Returns once the source has room for more. Refuses what is beyond its full scale:
  // it never clips.
  [[nodiscard]] virtual drivers::Status play(std::int64_t first_tick, const float* voltage_pu,
                                             std::size_t count) = 0;

  // Output off. May be called at any time, more than once, and after a failure.
  virtual void make_safe() noexcept = 0;
};

}  // namespace gsbench::source
