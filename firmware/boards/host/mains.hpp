// The mains of an outlet that runs without the bench: a file, a steady frequency, or a loss of
// generation. It is written into the terminals in real time.
#pragma once

#include <shared_memory_io/shared_memory.hpp>

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

namespace gs::host {

// A curve over time, interpolated linearly.
struct Curve {
  std::vector<double> t_s;  // ascending, from 0
  std::vector<double> value;
  bool is_voltage = false;  // value: instantaneous, per unit of the nominal amplitude; otherwise Hz
};

// Reads a CSV file with the columns t_s, in s, and frequency_hz or voltage_pu in its header; other
// columns are ignored, and voltage_pu wins if it has both. The first row becomes time 0. Returns
// false with the place and the reason in `why`. Frequencies must be 0.5 … 1.5 of nominal, voltages
// within ±1.5.
bool read_curve(const std::string& path, std::int32_t nominal_hz, Curve& curve, std::string& why);

// Nominal until `at_s`, then the answer of a power system of about 3000 MW (§6 of the paper) to a
// loss of generation.
Curve loss_curve(std::int32_t nominal_hz, double loss_mw, double at_s);

class Mains {
 public:
  // Plays an amplitude of 1 p.u. An empty curve is the nominal frequency. After a curve's end, its
  // last frequency stays; a voltage becomes 0.
  Mains(shared_memory_io::SharedMemory& terminals, Curve curve);

  // Writes the samples that are due since the first call. If it is called too late, the outlet
  // loses samples, as with a real ADC.
  void write_due();

 private:
  std::int16_t sample();

  shared_memory_io::SharedMemory& terminals_;
  Curve curve_;
  std::size_t at_ = 0;  // in the curve: the newest point that is not in the future
  std::uint64_t played_ = 0;
  double phase_ = 0.0;  // in periods
  bool started_ = false;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace gs::host
