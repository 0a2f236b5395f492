#include "rigs.hpp"
#include <test_support/mains.hpp>

#include <simulated/bench.hpp>

namespace gsbench::test {
namespace {

class SimulatedRig final : public LinkRig {
 public:
  SimulatedRig() : bench_(std::make_shared<simulated::Bench>(parameters())) {
    start(bench_->source(), mains_);
  }

  std::shared_ptr<link::Link> make_link() override { return {bench_, &bench_->link()}; }

  void play(int reports) override {
    tick_ += std::int64_t{reports} * 128;
    advance(bench_->source(), tick_);
  }

 private:
  static simulated::BenchParameters parameters() {
    simulated::BenchParameters parameters;
    parameters.outlet_ids = {"a", "b"};
    return parameters;
  }

  Mains mains_;
  std::shared_ptr<simulated::Bench> bench_;
  std::int64_t tick_ = 0;
};

}  // namespace

std::unique_ptr<LinkRig> simulated_rig() {
  return std::make_unique<SimulatedRig>();
}

}  // namespace gsbench::test
