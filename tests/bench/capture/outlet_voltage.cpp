#include "outlet_voltage.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <app/application.hpp>
#include <models/crystal_adc.hpp>
#include <outlet/front_end.hpp>
#include <station/played_signal.hpp>

namespace gsbench::capture::test {
namespace {

constexpr float kCounts_per_pu = 21845.0F;
constexpr std::size_t kBlock = 800;

class VoltageListener final : public gs::app::Outbox {
 public:
  VoltageListener(VoltageTrace& trace, std::uint64_t started) : trace_(trace), started_(started) {}

  void put(const gs::wire::Uplink& message) override {
    if (message.kind == gs::wire::UplinkKind::kMeasurement) {
      trace_.sample.push_back(started_ + message.sample);
      trace_.voltage_pu.push_back(message.measurement.voltage_pu);
    }
  }

 private:
  VoltageTrace& trace_;
  std::uint64_t started_;
};

}  // namespace

Played play(const profile::Plan& plan, const Crystal& crystal) {
  const station::PlayedSignal signal(plan, true);
  const std::int64_t rate_hz = plan.stimulus.sample_rate_hz;
  Played played;
  played.markers = signal.markers();
  played.run_ticks = plan.duration_ticks();
  played.trace.window_samples =
      2.0 * static_cast<double>(gs::outlet::kVoltageDelay_s) * static_cast<double>(rate_hz);

  VoltageListener listener(played.trace, crystal.started);
  gs::app::Application node;
  node.start({static_cast<std::int32_t>(rate_hz),
              static_cast<std::int32_t>(std::lround(plan.grid.nominal_hz)), kCounts_per_pu},
             {}, nullptr, listener);
  const std::vector<std::int16_t> silence(static_cast<std::size_t>(crystal.lead_in));
  node.feed(silence.data(), silence.size(), listener);

  models::CrystalAdc adc(crystal.ppm, kCounts_per_pu,
                         static_cast<float>(plan.stimulus.noise_rms_pu()),
                         {plan.seed, models::kSourceNoise, crystal.noise_index});
  played.samples_per_tick = 1.0 / adc.tick_of(1.0);
  played.zero_sample = static_cast<double>(crystal.started) + static_cast<double>(crystal.lead_in) +
                       static_cast<double>(signal.lead_ticks()) * played.samples_per_tick;
  std::vector<float> volts(kBlock);
  std::vector<std::int16_t> samples;
  for (std::int64_t tick = 0; tick < signal.total_ticks();) {
    const auto count =
        std::min<std::int64_t>(static_cast<std::int64_t>(kBlock), signal.total_ticks() - tick);
    signal.render(tick, static_cast<std::size_t>(count), volts.data());
    samples.clear();
    adc.take(volts.data(), static_cast<std::size_t>(count), samples);
    node.feed(samples.data(), samples.size(), listener);
    tick += count;
  }
  return played;
}

}  // namespace gsbench::capture::test
