// The outlets' terminals, fed at a higher rate than the outlets' own, as by the wire. That the
// direct source feeds them at the outlets' rate is in mains_test.cpp.
#include "fake_outlet.hpp"
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <cmath>

#include <gmock/gmock.h>

#include <emulation/terminals.hpp>

namespace gsbench::test {
namespace {

using emulation::MainsOutlet;
using emulation::Terminals;

constexpr std::int64_t kStepRate_hz = 64000;
constexpr double kPi = 3.14159265358979323846;

class AtTerminals : public testing::Test {
 protected:
  void make(std::vector<MainsOutlet> outlets) {
    terminals_ = demand(Terminals::create({folder_.path().string(), std::move(outlets)}));
    terminals_->connect(kStepRate_hz, {});
  }

  // Seconds of a sine of this frequency, 1 pu.
  void feed(double duration_s, double frequency_hz = 50.0) {
    std::vector<float> voltage_pu(128);
    for (const std::int64_t end = step_ + std::llround(duration_s * kStepRate_hz); step_ < end;) {
      for (float& pu : voltage_pu) {
        pu = static_cast<float>(
            std::sin(2.0 * kPi * frequency_hz * static_cast<double>(step_++) / kStepRate_hz));
      }
      terminals_->feed(voltage_pu.data(), voltage_pu.size());
      terminals_->wait_for_outlets();
    }
  }

  std::vector<models::ContactEdge> edges(std::size_t outlet, std::int64_t end_step) {
    std::vector<models::ContactEdge> taken;
    terminals_->take_edges(outlet, end_step, taken);
    return taken;
  }

  TemporaryFolder folder_;
  std::unique_ptr<Terminals> terminals_;
  std::int64_t step_ = 0;
};

TEST_F(AtTerminals, OutletsSampleAtTheirOwnRate) {
  make({{"slow", -500.0}, {"fast", 500.0}});
  std::vector<std::int16_t> taken;
  FakeOutlet slow(*terminals_, 0);
  FakeOutlet fast(*terminals_, 1, [&](const std::int16_t* samples, std::size_t count) {
    taken.insert(taken.end(), samples, samples + count);
  });
  feed(4.0);
  // 4 s at 8 kHz, ±500 ppm of 32 000.
  ASSERT_TRUE(until([&] { return slow.taken() >= 31984 - 1 && fast.taken() >= 32016 - 1; }));
  EXPECT_LE(slow.taken(), 31984U + 1U);
  EXPECT_LE(fast.taken(), 32016U + 1U);
  fast.end();
  EXPECT_NEAR(*std::max_element(taken.begin(), taken.end()), 32767 / 1.5, 3);
  EXPECT_NEAR(*std::min_element(taken.begin(), taken.end()), -32767 / 1.5, 3);
  // The sample at 3 s of a fast clock is 3 s · (1 − 500 ppm) in true time: −27° of 50 Hz.
  EXPECT_NEAR(taken[24000], 32767 / 1.5 * std::sin(2.0 * kPi * 50.0 * 3.0 / 1.0005), 4);
}

TEST_F(AtTerminals, EdgesCarryTheirInputStepAndWaitForIt) {
  make({{"a", 500.0}});
  FakeOutlet a(*terminals_, 0);
  feed(2.0);
  ASSERT_TRUE(until([&] { return a.taken() == terminals_->memory(0).written; }));
  a.drive_relay(false);
  // The coil changed at 2 s; the relay takes 6.5 ms to 9.5 ms.
  EXPECT_THAT(edges(0, 128000 + 408), testing::IsEmpty());
  const auto opening = edges(0, 128000 + 624);
  ASSERT_EQ(opening.size(), 1U);
  EXPECT_NEAR(static_cast<double>(opening[0].tick), 128000.0 + 512.0, 96.0 + 16.0);
  EXPECT_FALSE(opening[0].closed);
  EXPECT_THAT(edges(0, 2 * 128000), testing::IsEmpty()) << "each edge is taken once";
}

TEST_F(AtTerminals, AContactOnlyOutletOpensItsContactWithoutAProcess) {
  make({{"relay", 0.0, emulation::FrequencyRelayOptions{49.0, 0.2}}, {"other", 0.0}});
  FakeOutlet other(*terminals_, 1);
  feed(1.0, 50.0);
  EXPECT_THAT(edges(0, step_), testing::IsEmpty());
  const std::int64_t from = step_;
  feed(1.0, 48.5);
  const auto opening = edges(0, step_);
  ASSERT_EQ(opening.size(), 1U);
  // 0.2 s of delay, four to six periods, 8 ms of the contact.
  EXPECT_GT(opening[0].tick, from + 64 * (200 + 62 + 6));
  EXPECT_LT(opening[0].tick, from + 64 * (200 + 124 + 10));
  EXPECT_FALSE(opening[0].closed);
  EXPECT_THAT(edges(1, step_), testing::IsEmpty());
}

}  // namespace
}  // namespace gsbench::test
