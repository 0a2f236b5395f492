#include "rigs.hpp"

#include <simulated/bench.hpp>

namespace gsbench::test {
namespace {

class SimulatedRig final : public LinkRig {
 public:
  SimulatedRig() : bench_(std::make_shared<simulated::Bench>(parameters())) {
    source::SourceSettings settings;
    settings.sample_rate_hz = 8000;
    settings.nominal_hz = 50;
    EXPECT_TRUE(bench_->source().start(settings).ok());
  }

  std::shared_ptr<link::Link> make_link() override { return {bench_, &bench_->link()}; }

  void play(int reports) override {
    const std::vector<float> block(static_cast<std::size_t>(reports) * 128);
    EXPECT_TRUE(bench_->source().play(tick_, block.data(), block.size()).ok());
    tick_ += static_cast<std::int64_t>(block.size());
  }

 private:
  static simulated::BenchParameters parameters() {
    simulated::BenchParameters parameters;
    parameters.outlet_ids = {"a", "b"};
    return parameters;
  }

  std::shared_ptr<simulated::Bench> bench_;
  std::int64_t tick_ = 0;
};

}  // namespace

std::unique_ptr<LinkRig> simulated_rig() {
  return std::make_unique<SimulatedRig>();
}

}  // namespace gsbench::test
