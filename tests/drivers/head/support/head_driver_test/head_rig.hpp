// A driver with an emulated head, and the codes that the head should play.
#pragma once

#include <head_driver/head.hpp>
#include <head_driver_test/running_head.hpp>
#include <test_support/demand.hpp>
#include <test_support/mains.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <head/interpolator.hpp>
#include <models/noise.hpp>

namespace gsbench::test {

constexpr std::int64_t kCodesPerSample = gs::head::kOversampling;

struct HeadRig {
  explicit HeadRig(HeadPace pace = HeadPace::kAsFed,
                   const emulation::HeadEmulatorOptions& emulated = {})
      : head(pace, emulated), options(options_for(*head)) {
    head->record_codes();
    driver = head::Head::create(options).take();
  }
  source::Source& source() { return driver->source(); }
  relay::RelaySense& relay_sense() { return driver->relay_sense(); }

  // Energises, holds for some calls, and starts.
  void start(const source::Stimulus& stimulus, int holds = 3) {
    demand(source().prepare(stimulus));
    demand(source().energise());
    for (int i = 0; i < holds; ++i) {
      demand(source().hold());
    }
    demand(source().start());
  }
  // To the end of the stimulus, in blocks of 80 ticks.
  void play(const source::Stimulus& stimulus, std::int64_t from_tick = 0) {
    for (std::int64_t tick = from_tick; tick < stimulus.total_ticks();) {
      const auto played =
          source().advance(std::min<std::int64_t>(tick + 80, stimulus.total_ticks()));
      demand(played);
      tick = played.value();
    }
  }

  // Sample of the stream at tick 0.
  std::int64_t tick_0_sample() {
    const relay::Alignment alignment = relay_sense().alignment();
    return std::llround(alignment.count_at_tick_0 / alignment.counts_per_tick);
  }

  // All codes of the newest stream so far: the recording begins with code 0.
  std::vector<std::uint16_t> codes() {
    std::vector<std::uint16_t> all = head->recorded_codes();
    all.erase(all.begin(), all.begin() + head->observe().stream_begin);
    return all;
  }

  // The codes from sample 0 to the end of the stimulus, without the driver's own code. The stimulus
  // begins with phase 0.
  std::vector<std::uint16_t> expected(const source::Stimulus& stimulus) {
    constexpr double kTau = 6.283185307179586;
    const std::int64_t tick_0 = tick_0_sample();
    std::vector<float> voltage_pu(static_cast<std::size_t>(tick_0 + stimulus.total_ticks()));
    for (std::int64_t n = 0; n < tick_0; ++n) {
      const double rising = std::sin(0.25 * kTau * std::fmin(static_cast<double>(n) / 4000.0, 1.0));
      voltage_pu[static_cast<std::size_t>(n)] = static_cast<float>(
          rising * rising * std::cos(kTau * stimulus.nominal_hz() * static_cast<double>(n) / 8e3));
    }
    float* const played = voltage_pu.data() + tick_0;
    stimulus.render(0, static_cast<std::size_t>(stimulus.total_ticks()), played);
    models::add_gaussian({stimulus.noise().seed, models::kSourceNoise, 0}, 0,
                         static_cast<std::size_t>(stimulus.total_ticks()), stimulus.noise().rms_pu,
                         played);
    return interpolated(voltage_pu);
  }

  std::vector<std::uint16_t> interpolated(const std::vector<float>& voltage_pu) const {
    const double units = gs::head::kFullScale * std::sqrt(2.0) * options.nominal_v /
                         (options.gain * options.dac_full_scale_v);
    const auto sample = [units](float pu) {
      return static_cast<std::int16_t>(std::lround(units * static_cast<double>(pu)));
    };
    gs::head::Interpolator interpolator;
    interpolator.begin(sample(voltage_pu[0]));
    std::vector<std::uint16_t> codes;
    for (std::size_t n = 0; n + 1 < voltage_pu.size(); ++n) {
      for (std::int64_t code = 0; code < kCodesPerSample; ++code) {
        if (interpolator.needs_sample()) {
          interpolator.add(sample(voltage_pu[n + 1]));
        }
        codes.push_back(interpolator.next());
      }
    }
    return codes;
  }

  RunningHead head;
  head::HeadOptions options;
  std::unique_ptr<head::Head> driver;
};

// Largest difference over the first `count` codes. A sample that was lost, or played twice, differs
// from then on by up to 70 steps.
inline int largest_difference(const std::vector<std::uint16_t>& a,
                              const std::vector<std::uint16_t>& b, std::size_t count) {
  int largest = a.size() < count || b.size() < count ? 4096 : 0;
  for (std::size_t i = 0; i < count && largest < 4096; ++i) {
    largest = std::max(largest, std::abs(int{a[i]} - int{b[i]}));
  }
  return largest;
}

}  // namespace gsbench::test
