// An emulated waveform generator, its driver, and an outlet that samples its output in true time.
#include "generator_rig.hpp"
#include "measuring_outlet.hpp"
#include "rigs.hpp"

#include <cmath>

namespace gsbench::test {
namespace {

constexpr std::int64_t kStepsPerAdcSample = emulation::TrueTime::kRate_hz / 8000;

class ScpiSourceRig final : public SourceRig {
 public:
  ScpiSourceRig() : rig_(kGeneratorCases[1]) {
    // 16 points a tick, so that a single sample of the stimulus is played.
    rig_.instrument.memory.points = 400000;
    source_ = rig_.make_source();
    render_until(1);  // from now on, the emulator keeps what happens until it is rendered
  }
  source::Source& source() override { return *source_; }

  std::vector<Reading> readings() override {
    render_until(rig_.time.now());
    const auto clock = source_->host_clock();
    const std::int64_t tick_0 =
        clock ? rig_.time.step_of(clock->tick_0) / kStepsPerAdcSample : std::int64_t{1} << 40;
    return outlet_.measurements().after(tick_0);
  }

 private:
  void render_until(std::int64_t step) {
    std::vector<float> volts(static_cast<std::size_t>(step - rendered_));
    rig_.generator().render(rendered_, volts.size(), volts.data());
    rendered_ = step;
    const scpi::Wiring& wiring = rig_.options.plan.wiring;
    for (const float volt : volts) {
      sum_v_ += static_cast<double>(volt);
      if (++summed_ == kStepsPerAdcSample) {
        outlet_.feed(sum_v_ / static_cast<double>(kStepsPerAdcSample) * wiring.gain /
                     (wiring.nominal_v * std::sqrt(2.0)));
        sum_v_ = 0.0;
        summed_ = 0;
      }
    }
  }

  GeneratorRig rig_;
  std::shared_ptr<source::Source> source_;
  MeasuringOutlet outlet_;
  std::int64_t rendered_ = 0;  // steps
  double sum_v_ = 0.0;
  std::int64_t summed_ = 0;
};

}  // namespace

std::unique_ptr<SourceRig> scpi_source() {
  return std::make_unique<ScpiSourceRig>();
}

}  // namespace gsbench::test
