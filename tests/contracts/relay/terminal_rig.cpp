#include "rigs.hpp"
#include <test_support/clocked_source.hpp>
#include <test_support/mains.hpp>

#include <algorithm>
#include <vector>

#include <emulation/terminal_sense.hpp>
#include <models/relay_model.hpp>

namespace gsbench::test {
namespace {

constexpr double kSourceFast_ppm = 150.0;
constexpr double kStartAfter_s = 1.7;  // tick 0 in true time
constexpr std::int64_t kDipFrom = 2000;
constexpr std::int64_t kDipTo = 3200;

// Nominal voltage with a dip from 0.25 s to 0.4 s, before the suite begins.
struct DippedMains final : Mains {
  static bool is_dipped(double tick) { return tick >= kDipFrom && tick < kDipTo; }
  double amplitude_pu(std::int64_t tick) const override {
    return is_dipped(static_cast<double>(tick)) ? 0.85 : 1.0;
  }
  void render(std::int64_t first_tick, std::size_t count, float* out) const override {
    Mains::render(first_tick, count, out);
    for (std::size_t i = 0; i < count; ++i) {
      out[i] *= static_cast<float>(amplitude_pu(first_tick + static_cast<std::int64_t>(i)));
    }
  }
};

// The emulated terminals of two outlets, as the wire from an instrument feeds them: voltage and
// edges in steps of true time, of which the source counts 150 ppm more ticks.
class TerminalRig final : public RelayRig {
 public:
  TerminalRig() { source_.clock = {time_.start, 1.0 / 8000.0, 0.0001}; }
  relay::RelaySense& sense() override { return sense_; }
  void turn(std::size_t channel, bool closed) override {
    const models::Stream stream{1, models::kTest, static_cast<std::uint32_t>(channel)};
    for (const models::ContactEdge& edge :
         contact_edges({}, stream, turns_++, step_, closed, emulation::TrueTime::kRate_hz)) {
      due_.push_back({edge.tick, channel, edge.closed});
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& a, const Due& b) { return a.step < b.step; });
  }
  void advance(std::int64_t until_tick) override {
    const auto until_step = static_cast<std::int64_t>(
        emulation::TrueTime::kRate_hz * kStartAfter_s +
        static_cast<double>(until_tick) * 8.0 / (1.0 + 1e-6 * kSourceFast_ppm));
    std::vector<float> voltage_pu;
    for (; step_ < until_step; ++step_) {
      voltage_pu.push_back(at_terminals(step_));
    }
    sense_.seen(voltage_pu.data(), voltage_pu.size());
    for (; !due_.empty() && due_.front().step < step_; due_.erase(due_.begin())) {
      sense_.moved(due_.front().channel, due_.front().step, due_.front().closed);
    }
  }

 private:
  struct Due {
    std::int64_t step;
    std::size_t channel;
    bool closed;
  };

  // Nominal voltage before the stimulus, too.
  static float at_terminals(std::int64_t step) {
    constexpr double kTau = 6.283185307179586;
    const double t_s = (static_cast<double>(step) + 0.5) / emulation::TrueTime::kRate_hz;
    const double tick = (t_s - kStartAfter_s) * 8000.0 * (1.0 + 1e-6 * kSourceFast_ppm);
    return static_cast<float>((DippedMains::is_dipped(tick) ? 0.85 : 1.0) *
                              std::cos(kTau * 50.0 * tick / 8000.0));
  }

  DippedMains stimulus_;
  ClockedSource source_;
  emulation::TrueTime time_;
  emulation::TerminalSense sense_{stimulus_, source_, kSourceFast_ppm, time_};
  std::int64_t step_ = 0;
  std::uint64_t turns_ = 0;
  std::vector<Due> due_;
};

}  // namespace

std::unique_ptr<RelayRig> terminal_sense() {
  return std::make_unique<TerminalRig>();
}

}  // namespace gsbench::test
