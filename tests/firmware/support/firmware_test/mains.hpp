// What an outlet's ADC would deliver: a synthesised voltage with noise, rounded to counts.
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

// Held at the first frequency until `at_s`, then linear to the last one, which is held.
std::shared_ptr<const gsbench::waveform::ReferenceSignal> ramp(double from_hz, double to_hz,
                                                               double at_s, double hz_per_s);

// An outlet at a mains, without settings where none are given. Throws std::logic_error where the
// firmware does not serve its hardware or refuses the settings.
struct PlayedOutlet {
  using Each = std::function<void(const outlet::Report&)>;

  explicit PlayedOutlet(const MainsSpec& spec);
  PlayedOutlet(const MainsSpec& spec, const outlet::Settings& settings);

  // The first `duration_s` seconds, each report given to `each`.
  void play(double duration_s, const Each& each);
  // From one tick to before another.
  void play(std::int64_t from, std::int64_t end, const Each& each);

  Mains mains;
  outlet::Config config;
  outlet::State state;
};

// The reports of an outlet with these settings from its start-up on.
std::vector<outlet::Report> reports_of(const MainsSpec& spec, double duration_s,
                                       const outlet::Settings& settings);

// When a report was made, and the instant that its frequency is of.
constexpr double report_s(const outlet::Report& report) {
  return 0.016 * (static_cast<double>(report.number) + 1.0);
}
constexpr double measured_s(const outlet::Report& report) {
  return report_s(report) - static_cast<double>(outlet::kFrontEndDelay_s);
}

}  // namespace gs::test
