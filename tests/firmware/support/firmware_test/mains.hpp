// Simulated samples of an outlet's ADC: a synthesised voltage with noise, rounded to counts.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include <outlet/outlet.hpp>
#include <waveform/reference_signal.hpp>
#include <waveform/synthesizer.hpp>

namespace gs::test {

struct MainsSpec {
  std::shared_ptr<const gsbench::waveform::ReferenceSignal> reference;
  gsbench::waveform::SignalSpec signal = {};
  double noise_pct = 0.0;  // white, RMS, of the nominal amplitude (peak)
  std::uint64_t seed = 1;
  std::int32_t sample_rate_hz = 8000;
};

class Mains {
 public:
  explicit Mains(const MainsSpec& spec);

  outlet::Hardware hardware() const;
  std::int64_t ticks_per_report() const { return synthesizer_.sample_rate_hz() * 16 / 1000; }

  // Samples first_tick … first_tick+count−1.
  std::vector<std::int16_t> samples(std::int64_t first_tick, std::size_t count) const;

 private:
  gsbench::waveform::Synthesizer synthesizer_;
  float noise_rms_pu_;
  std::uint64_t seed_;
};

std::shared_ptr<const gsbench::waveform::ReferenceSignal> steady(double nominal_hz,
                                                                 double frequency_hz);

// Constant from_hz until `at_s`, then a ramp to to_hz, which stays constant.
std::shared_ptr<const gsbench::waveform::ReferenceSignal> ramp(double from_hz, double to_hz,
                                                               double at_s, double hz_per_s);

// An outlet connected to simulated mains, with or without settings. The constructor throws
// std::logic_error if the firmware does not support the hardware or refuses the settings.
struct PlayedOutlet {
  using Each = std::function<void(const outlet::Report&)>;

  explicit PlayedOutlet(const MainsSpec& spec);
  PlayedOutlet(const MainsSpec& spec, const outlet::Settings& settings);

  // Plays the first `duration_s` seconds; calls `each` with each report.
  void play(double duration_s, const Each& each);
  // Plays the ticks from … end − 1.
  void play(std::int64_t from, std::int64_t end, const Each& each);

  Mains mains;
  outlet::Config config;
  outlet::State state;
};

// The reports of an outlet with these settings, from its start-up.
std::vector<outlet::Report> reports_of(const MainsSpec& spec, double duration_s,
                                       const outlet::Settings& settings);

// The time of a report, and the instant to which its frequency belongs.
constexpr double report_s(const outlet::Report& report) {
  return 0.016 * (static_cast<double>(report.number) + 1.0);
}
constexpr double measured_s(const outlet::Report& report) {
  return report_s(report) - static_cast<double>(outlet::kFrontEndDelay_s);
}

}  // namespace gs::test
