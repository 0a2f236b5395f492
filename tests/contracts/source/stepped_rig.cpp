// A model of an AC source with a list of steps: holds frequency and voltage, both with a finite
// resolution, for each step. The phase is continuous.
#include "measuring_outlet.hpp"

#include <cmath>

namespace gsbench::test {
namespace {

constexpr double kSteppedFullScale_pu = 1.3;
constexpr std::int64_t kStepTicks = 160;  // 20 ms
constexpr double kResolution_hz = 0.001;
constexpr double kResolution_pu = 0.0005;

struct Step {
  double frequency_hz;
  double voltage_pu;
};

class SteppedSource final : public source::Source {
 public:
  explicit SteppedSource(MeasuringOutlet& outlet) : outlet_(outlet) {}

  source::Limits limits() const override {
    return {"AC source", source::Kind::kStepped, kSteppedFullScale_pu, 60.0, {8000}, {50}, false};
  }

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus& stimulus) const override {
    const std::vector<Step> steps = steps_of(stimulus);
    source::Played played;
    double late_cycles = 0.0;
    for (std::int64_t tick = 0; tick < stimulus.total_ticks(); ++tick) {
      const Step& step = steps[static_cast<std::size_t>(tick / kStepTicks)];
      const double wanted_hz = stimulus.frequency_hz(tick);
      const double wanted_pu = stimulus.amplitude_pu(tick);
      late_cycles += (wanted_hz - step.frequency_hz) / 8000.0;
      played.frequency_hz =
          std::fmax(played.frequency_hz, std::fabs(step.frequency_hz - wanted_hz));
      played.voltage_pu = std::fmax(played.voltage_pu, std::fabs(step.voltage_pu - wanted_pu));
      played.time_s = std::fmax(played.time_s, std::fabs(late_cycles) / wanted_hz);
    }
    return played;
  }

  drivers::Status upload(const source::Progress& progress) override {
    steps_ = steps_of(stimulus());
    if (progress) {
      progress(1.0);
    }
    return drivers::Done{};
  }

  drivers::Status power_up() override { return drivers::Done{}; }

  drivers::Status begin() override {
    cycles_ = 0.0;
    return drivers::Done{};
  }

  // It reports the current step only, not the position within it.
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const std::int64_t step_end = (until_tick + kStepTicks - 1) / kStepTicks * kStepTicks;
    const std::int64_t end = std::min(step_end, stimulus().total_ticks());
    for (std::int64_t n = tick(); n < end; ++n) {
      const Step& step = steps_[static_cast<std::size_t>(n / kStepTicks)];
      outlet_.feed(step.voltage_pu * std::cos(6.283185307179586 * cycles_));
      cycles_ = std::fmod(cycles_ + step.frequency_hz / 8000.0, 1.0);
    }
    return end;
  }

  drivers::Status switch_off() noexcept override { return drivers::Done{}; }

 private:
  // The stimulus's values in the middle of each step.
  static std::vector<Step> steps_of(const source::Stimulus& stimulus) {
    std::vector<Step> steps;
    for (std::int64_t tick = 0; tick < stimulus.total_ticks(); tick += kStepTicks) {
      const std::int64_t middle = std::min(tick + kStepTicks / 2, stimulus.total_ticks() - 1);
      steps.push_back(
          {kResolution_hz * std::round(stimulus.frequency_hz(middle) / kResolution_hz),
           kResolution_pu * std::round(stimulus.amplitude_pu(middle) / kResolution_pu)});
    }
    return steps;
  }

  MeasuringOutlet& outlet_;
  std::vector<Step> steps_;
  double cycles_ = 0.0;
};

class SteppedRig final : public SourceRig {
 public:
  source::Source& source() override { return source_; }
  std::vector<Reading> readings() override { return outlet_.measurements().after(0); }

 private:
  MeasuringOutlet outlet_;
  SteppedSource source_{outlet_};
};

}  // namespace

std::unique_ptr<SourceRig> stepped_source() {
  return std::make_unique<SteppedRig>();
}

}  // namespace gsbench::test
