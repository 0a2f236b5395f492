#include "measuring_outlet.hpp"
#include "rigs.hpp"
#include <head_driver_test/running_head.hpp>

#include <cmath>
#include <mutex>

namespace gsbench::test {
namespace {

constexpr double kNominal_v = 230.0;
constexpr double kGain = 260.0;
constexpr std::int64_t kStepsPerSample = emulation::TrueTime::kRate_hz / 8000;

// An emulated head with a slow crystal. The outlet samples its output, through gain and low-pass
// (the mean over a sample), in true time.
class HeadSourceRig final : public SourceRig {
 public:
  HeadSourceRig()
      : head_(HeadPace::kAsFed, emulated(),
              [this](std::int64_t, const float* volts, std::size_t count) { take(volts, count); }) {
    head::HeadOptions options = options_for(*head_);
    options.gain = kGain;
    options.nominal_v = kNominal_v;
    options.clock_ppm = 50.0;
    driver_ = head::Head::create(options).take();
  }
  source::Source& source() override { return driver_->source(); }

  std::vector<Reading> readings() override {
    const relay::Alignment alignment = driver_->relay_sense().alignment();
    const bool started = alignment.count_at_tick_0 > alignment.counts_per_tick;
    const double begin = static_cast<double>(head_->observe().stream_begin) / kStepsPerSample +
                         alignment.count_at_tick_0 / alignment.counts_per_tick;
    const std::lock_guard<std::mutex> lock(mutex_);
    // The head is slow by less than half a sample in the 2 s of the suite.
    return outlet_.measurements().after(started ? std::llround(begin) : std::int64_t{1} << 40);
  }

 private:
  static emulation::HeadEmulatorOptions emulated() {
    emulation::HeadEmulatorOptions options;
    options.clock_ppm = -20.0;
    return options;
  }

  void take(const float* volts, std::size_t count) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (std::size_t i = 0; i < count; ++i) {
      sum_v_ += static_cast<double>(volts[i]);
      if (++summed_ == kStepsPerSample) {
        const double mean_v = sum_v_ / static_cast<double>(kStepsPerSample);
        outlet_.feed(mean_v * kGain / (kNominal_v * std::sqrt(2.0)));
        sum_v_ = 0.0;
        summed_ = 0;
      }
    }
  }

  std::mutex mutex_;
  MeasuringOutlet outlet_;
  double sum_v_ = 0.0;
  std::int64_t summed_ = 0;
  RunningHead head_;  // its thread ends before the members it uses
  std::unique_ptr<head::Head> driver_;
};

}  // namespace

std::unique_ptr<SourceRig> head_source() {
  return std::make_unique<HeadSourceRig>();
}

}  // namespace gsbench::test
