// What an instrument is set to for a waveform: rate, number of points and amplitude. Refuses, with
// value and limit, what is beyond its ranges.
#pragma once

#include <source_scpi/instrument.hpp>
#include <source_scpi/planner.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <source/stimulus.hpp>

namespace gsbench::scpi {

constexpr double kSqrt2 = 1.41421356237309515;  // peak of a sine over its RMS

struct ChosenRate {
  double rate_hz = 0.0;       // points a second
  double frequency_hz = 0.0;  // repetitions a second of all points
  std::int64_t points = 0;
};

// Rates to try, the usual one first, and why the last of them cannot be higher, for messages.
struct Rates {
  std::vector<ChosenRate> rates;  // one or two
  std::string highest_is;         // "16 times the rate of the stimulus"
};

// The usual rate is four, three, two or one times that of the stimulus. The other one is the
// highest that memory and instrument permit, at most 16 times that of the stimulus. The waveform
// lasts `duration_s`. Samples of the stimulus are not needed.
drivers::Result<Rates> choose_rates(const Instrument& instrument, const source::Stimulus& stimulus,
                                    double duration_s);

// Vpp at the instrument's terminals, a step of the instrument, at which `peak_pu` of nominal peak
// fits. Not above the voltage limit.
drivers::Result<double> choose_amplitude(const Instrument& instrument, const Wiring& wiring,
                                         double peak_pu);

}  // namespace gsbench::scpi
