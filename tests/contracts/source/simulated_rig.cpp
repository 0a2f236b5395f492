#include "measuring_outlet.hpp"

#include <gtest/gtest.h>

#include <simulated/bench.hpp>

namespace gsbench::test {
namespace {

class SimulatedRig final : public SourceRig {
 public:
  SimulatedRig() : bench_({{"outlet"}, {}, simulated::Pace::kVirtual, 1}) {}
  source::Source& source() override { return bench_.source(); }

  std::vector<Reading> readings() override {
    link::Happenings happenings;
    EXPECT_TRUE(bench_.link().poll(happenings).ok());
    for (const link::Change& change : happenings.changes) {
      measurements_.take_hello(std::get<link::OutletPresence>(change).hello);
    }
    for (const link::Received& received : happenings.messages) {
      measurements_.put(received.message);
    }
    return measurements_.after(0);
  }

 private:
  simulated::Bench bench_;
  Measurements measurements_;
};

}  // namespace

std::unique_ptr<SourceRig> simulated_source() {
  return std::make_unique<SimulatedRig>();
}

}  // namespace gsbench::test
