#include "rigs.hpp"
#include <test_support/mains.hpp>
#include <wire_test/downlinks.hpp>

#include <gtest/gtest.h>

#include <simulated/bench.hpp>

namespace gsbench::test {
namespace {

class SimulatedRig final : public RelayRig {
 public:
  SimulatedRig() {
    simulated::BenchParameters parameters;
    parameters.outlet_ids = {"a", "b"};
    parameters.outlet.downlink_ms = 0.0;
    bench_ = std::make_unique<simulated::Bench>(parameters);
    start(bench_->source(), mains_);
  }
  relay::RelaySense& sense() override { return bench_->relay_sense(); }
  void turn(std::size_t channel, bool closed) override {
    const auto command = gs::wire::test::command(closed);
    EXPECT_TRUE(bench_->link().send(channel == 0 ? "a" : "b", command).ok());
  }
  void advance(std::int64_t until_tick) override { test::advance(bench_->source(), until_tick); }

 private:
  Mains mains_;
  std::unique_ptr<simulated::Bench> bench_;
};

}  // namespace

std::unique_ptr<RelayRig> simulated_sense() {
  return std::make_unique<SimulatedRig>();
}

}  // namespace gsbench::test
