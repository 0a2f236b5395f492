#include <firmware_test/mains.hpp>

#include <algorithm>
#include <stdexcept>

#include <models/adc.hpp>
#include <models/noise.hpp>

namespace gs::test {

namespace waveform = gsbench::waveform;

Mains::Mains(const MainsSpec& spec)
    : synthesizer_(spec.reference, spec.signal, spec.sample_rate_hz),
      noise_rms_pu_(static_cast<float>(spec.noise_pct / 100.0)),
      seed_(spec.seed) {}

outlet::Hardware Mains::hardware() const {
  outlet::Hardware hardware;
  hardware.sample_rate_hz = static_cast<std::int32_t>(synthesizer_.sample_rate_hz());
  hardware.nominal_hz = static_cast<std::int32_t>(synthesizer_.reference().nominal_hz());
  hardware.counts_per_pu = gsbench::models::kCounts_per_pu;
  return hardware;
}

std::vector<std::int16_t> Mains::samples(std::int64_t first_tick, std::size_t count) const {
  std::vector<float> volts(count);
  synthesizer_.render(first_tick, count, volts.data());
  if (noise_rms_pu_ > 0.0F) {
    gsbench::models::add_gaussian({seed_, gsbench::models::kTest, 0},
                                  static_cast<std::uint64_t>(first_tick), count, noise_rms_pu_,
                                  volts.data());
  }
  std::vector<std::int16_t> counts(count);
  std::transform(volts.begin(), volts.end(), counts.begin(), [](float volt) {
    return gsbench::models::adc_counts(volt, gsbench::models::kCounts_per_pu);
  });
  return counts;
}

std::shared_ptr<const waveform::ReferenceSignal> steady(double nominal_hz, double frequency_hz) {
  return waveform::reference_from_points(nominal_hz, {{0.0, frequency_hz}});
}

std::shared_ptr<const waveform::ReferenceSignal> ramp(double from_hz, double to_hz, double at_s,
                                                      double hz_per_s) {
  const double end_s = at_s + (to_hz - from_hz) / hz_per_s;
  return waveform::reference_from_points(50.0, {{at_s, from_hz}, {end_s, to_hz}});
}

PlayedOutlet::PlayedOutlet(const MainsSpec& spec) : mains(spec) {
  if (!outlet::configure(mains.hardware(), config)) {
    throw std::logic_error("hardware not supported by the firmware");
  }
}

PlayedOutlet::PlayedOutlet(const MainsSpec& spec, const outlet::Settings& settings)
    : PlayedOutlet(spec) {
  const outlet::SettingsError error = outlet::apply(config, state, settings);
  if (error != outlet::SettingsError::kNone) {
    throw std::logic_error(outlet::to_string(error));
  }
}

void PlayedOutlet::play(double duration_s, const Each& each) {
  play(0, static_cast<std::int64_t>(duration_s * mains.hardware().sample_rate_hz), each);
}

void PlayedOutlet::play(std::int64_t from, std::int64_t end, const Each& each) {
  const std::int64_t block = 16 * mains.ticks_per_report();
  for (std::int64_t tick = from; tick < end; tick += block) {
    const auto count = static_cast<std::size_t>(std::min(block, end - tick));
    const std::vector<std::int16_t> samples = mains.samples(tick, count);
    std::size_t done = 0;
    while (done < count) {
      outlet::Report report;
      bool ready = false;
      done += outlet::step(config, state, samples.data() + done, count - done, report, ready);
      if (ready) {
        each(report);
      }
    }
  }
}

std::vector<outlet::Report> reports_of(const MainsSpec& spec, double duration_s,
                                       const outlet::Settings& settings) {
  std::vector<outlet::Report> reports;
  PlayedOutlet(spec, settings).play(duration_s, [&](const outlet::Report& report) {
    reports.push_back(report);
  });
  return reports;
}

}  // namespace gs::test
