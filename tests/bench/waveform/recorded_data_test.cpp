// The blackout of 28 April 2025 as a grid analyser in Toledo saw it, every 2 s. The recording is
// not part of the repository: set GSBENCH_RECORDED_DATA to the folder it is in.
#include "example_truths.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

namespace gsbench::waveform {
namespace {

class ToledoRecording : public testing::Test {
 protected:
  void SetUp() override {
    const char* folder = std::getenv("GSBENCH_RECORDED_DATA");
    const std::string path = std::string(folder != nullptr ? folder : GSBENCH_RECORDED_DATA) +
                             "/iberia-2025-04-28-toledo.csv";
    if (!std::filesystem::exists(path)) {
      GTEST_SKIP() << path << " is not there: set GSBENCH_RECORDED_DATA to its folder";
    }
    points_ = read_trace(path, {"time", "AnalyzerL1Frequency", "AnalyzerL1PhaseVoltage", 0.0});
  }

  static constexpr double kLastOrdinaryS = 93 * 60 + 16;  // 12:33:16, from 11:00:00
  static constexpr double kDeadS = kLastOrdinaryS + 8;

  std::vector<TracePoint> points_;
};

TEST_F(ToledoRecording, IsReadAsItIsWritten) {
  ASSERT_EQ(points_.size(), 3590u);  // 3600 rows, ten of which are gaps
  EXPECT_EQ(points_.front().frequency_hz, 50.016);
  const std::shared_ptr<const Truth> truth = truth_from_trace(50.0, points_);
  EXPECT_EQ(truth->frequency_hz(kLastOrdinaryS), 49.942);
  EXPECT_EQ(truth->frequency_hz(kLastOrdinaryS + 4), 48.556);
  EXPECT_EQ(truth->frequency_hz(kLastOrdinaryS + 6), 47.476);
  EXPECT_NEAR(truth->voltage_pu(600.0), 1.0, 0.05);
}

TEST_F(ToledoRecording, PlaysADeadBusAsOne) {
  const Synthesizer synthesizer(truth_from_trace(50.0, points_), {}, 8000);
  const auto dead_tick = static_cast<std::int64_t>(kDeadS * 8000.0);
  float before = 0.0f;
  for (const float sample : render(synthesizer, dead_tick - 10 * 8000, 160)) {
    before = std::max(before, std::fabs(sample));
  }
  EXPECT_NEAR(static_cast<double>(before), 1.0, 0.1);
  for (const float sample : render(synthesizer, dead_tick, 10 * 8000)) {
    ASSERT_LT(std::fabs(sample), 0.02f);
  }
}

}  // namespace
}  // namespace gsbench::waveform
