#include "rigs.hpp"
#include <head_driver_test/running_head.hpp>
#include <test_support/mains.hpp>

#include <cmath>

#include <models/relay_model.hpp>

namespace gsbench::test {
namespace {

constexpr double kFast_ppm = 200.0;

// An emulated head with a fast crystal. Its time goes on in advance() only.
class HeadRelayRig final : public RelayRig {
 public:
  HeadRelayRig() : head_(HeadPace::kAsFed, options()) {
    for (std::size_t channel = 0; channel < gs::head::kInputs; ++channel) {
      head_->set_input(channel, 0, true);
    }
    driver_ = head::Head::create(options_for(*head_)).take();
    demand(driver_->source().prepare(stimulus_));
    demand(driver_->source().energise());
    head_.freeze();
    demand(driver_->source().start());
  }
  relay::RelaySense& sense() override { return driver_->relay_sense(); }
  void turn(std::size_t channel, bool closed) override {
    const models::Stream stream{1, models::kTest, static_cast<std::uint32_t>(channel)};
    for (const models::ContactEdge& edge :
         contact_edges({}, stream, turns_++, head_.step(), closed, emulation::TrueTime::kRate_hz)) {
      head_->set_input(channel, edge.tick, edge.closed);
    }
  }
  void advance(std::int64_t until_tick) override {
    const relay::Alignment alignment = sense().alignment();
    const double samples =
        alignment.count_at_tick_0 / alignment.counts_per_tick + static_cast<double>(until_tick);
    const double codes = static_cast<double>(head_->observe().stream_begin) + 8.0 * samples;
    head_.stop_at(static_cast<std::int64_t>(codes / (1.0 + 1e-6 * kFast_ppm)) + 1);
    test::advance(driver_->source(), until_tick);
  }

 private:
  static emulation::HeadEmulatorOptions options() {
    emulation::HeadEmulatorOptions options;
    options.clock_ppm = kFast_ppm;
    return options;
  }

  Mains stimulus_;
  RunningHead head_;
  std::unique_ptr<head::Head> driver_;
  std::uint64_t turns_ = 0;
};

}  // namespace

std::unique_ptr<RelayRig> head_sense() {
  return std::make_unique<HeadRelayRig>();
}

}  // namespace gsbench::test
