// A recorded collapse is played as recorded: falling frequency, then a dead bus, even if the
// recording still contains frequencies there.
#include "example_references.hpp"
#include <test_support/collapse_recordings.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <recording/trace.hpp>

namespace gsbench::waveform {
namespace {

std::vector<recording::TracePoint> read(const std::string& path) {
  return recording::read_trace(
             recording::read_trace_file(path), path,
             {test::kCollapseTime, test::kCollapseFrequency, test::kCollapseVoltage})
      .points;
}

TEST(RecordedCollapse, IsReadWithTheRecordedFrequencies) {
  const test::TemporaryFolder folder;
  for (const test::CollapseRecording& collapse : test::collapse_recordings(folder)) {
    SCOPED_TRACE(collapse.path);
    const auto points = read(collapse.path);
    EXPECT_EQ(points.size(), collapse.points);
    const std::shared_ptr<const ReferenceSignal> reference = reference_from_points(50.0, points);
    EXPECT_EQ(reference->frequency_hz(collapse.last_ordinary_s), 49.942);
    EXPECT_EQ(reference->frequency_hz(collapse.last_ordinary_s + 4), 48.556);
    EXPECT_EQ(reference->frequency_hz(collapse.last_ordinary_s + 6), 47.476);
    EXPECT_NEAR(reference->voltage_pu(100.0), 1.0, 0.05);
  }
}

TEST(RecordedCollapse, IsPlayedWithoutVoltageOnTheDeadBus) {
  const test::TemporaryFolder folder;
  for (const test::CollapseRecording& collapse : test::collapse_recordings(folder)) {
    SCOPED_TRACE(collapse.path);
    const Synthesizer synthesizer(reference_from_points(50.0, read(collapse.path)), {}, 8000);
    const auto dead_tick = static_cast<std::int64_t>((collapse.last_ordinary_s + 8) * 8000.0);
    float before = 0.0f;
    for (const float sample : render(synthesizer, dead_tick - 10 * 8000, 160)) {
      before = std::max(before, std::fabs(sample));
    }
    EXPECT_NEAR(static_cast<double>(before), 1.0, 0.1);
    for (const float sample : render(synthesizer, dead_tick, 10 * 8000)) {
      ASSERT_LT(std::fabs(sample), 0.02f);
    }
  }
}

}  // namespace
}  // namespace gsbench::waveform
