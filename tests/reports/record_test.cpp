#include "sample_run.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include <record/run_record.hpp>
#include <record/store.hpp>

namespace gsbench::record {
namespace {

TEST(Verdict, OnlyWorsensWhenCombinedWithMax) {
  EXPECT_EQ(std::max(Verdict::kPass, Verdict::kInconclusive), Verdict::kInconclusive);
  EXPECT_EQ(std::max(Verdict::kFail, Verdict::kInconclusive), Verdict::kFail);
  EXPECT_EQ(std::max(Verdict::kFail, Verdict::kError), Verdict::kError);
}

TEST(Verdict, IsReadBackFromItsWord) {
  for (const Verdict verdict :
       {Verdict::kPass, Verdict::kInconclusive, Verdict::kFail, Verdict::kError}) {
    EXPECT_EQ(verdict_from_string(to_string(verdict)), verdict);
  }
  EXPECT_THROW(verdict_from_string("pass"), std::invalid_argument);
}

TEST(ContentDigest, LeavesOutRunIdAndWallClock) {
  const RunRecord first = sample::loss_500mw(2);
  RunRecord second = first;
  second.run_id = "another";
  second.started_utc = "2030-01-01T00:00:00Z";
  second.finished_utc = "2030-01-01T00:00:09Z";
  EXPECT_EQ(content_digest(first), content_digest(second));
  EXPECT_EQ(content_digest(first).size(), 64U);
}

TEST(ContentDigest, ChangesWithEveryOtherPartOfTheRecord) {
  const RunRecord original = sample::loss_500mw(2);
  const std::string digest = content_digest(original);
  const std::vector<std::function<void(RunRecord&)>> changes = {
      [](RunRecord& run) { run.seed ^= 1U; },
      [](RunRecord& run) { run.verdict = Verdict::kFail; },
      [](RunRecord& run) { run.profile_text += " "; },
      [](RunRecord& run) { run.grid_sha256 = "ab"; },
      [](RunRecord& run) { run.recording.sha256 = "ab"; },
      [](RunRecord& run) { run.recording.replaces_profile = true; },
      [](RunRecord& run) { run.interrupted = true; },
      [](RunRecord& run) { run.fault = "no source"; },
      [](RunRecord& run) { run.bench_uncertainty.relay_sense_ms = 0.1; },
      [](RunRecord& run) { run.bench_uncertainty.frequency_mhz = 0.1; },
      [](RunRecord& run) { run.outlets[1].took_part = true; },
      [](RunRecord& run) { run.comparisons[0].ours += 1e-9; },
      [](RunRecord& run) { run.truth.frequency_hz[7] = std::nextafter(50.0, 51.0); },
      [](RunRecord& run) { run.stimulus[0].tick += 1; },
      [](RunRecord& run) { run.outlets.pop_back(); },
      [](RunRecord& run) { std::swap(run.outlets[0], run.outlets[1]); },
      [](RunRecord& run) { run.outlets[1].settings["threshold_mw"] += 0.01; },
      [](RunRecord& run) { run.outlets[1].measurements[3].value += 1e-9; },
      [](RunRecord& run) { run.outlets[1].marks[0].kind = "lse"; },
      [](RunRecord& run) { run.outlets[1].trace.validity[100] = 2; },
      [](RunRecord& run) { run.outlets[1].estimates.trusted[20] = 0; },
      // Text moved over a field's border is another text.
      [](RunRecord& run) {
        run.grid += run.station.front();
        run.station.erase(0, 1);
      },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    RunRecord changed = original;
    changes[i](changed);
    EXPECT_NE(content_digest(changed), digest) << "change " << i;
  }
}

TEST(ContentDigest, TakesEveryNanForTheSame) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].trace.frequency_hz[0] = std::numeric_limits<float>::quiet_NaN();
  const std::string digest = content_digest(run);
  run.outlets[0].trace.frequency_hz[0] = -std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(content_digest(run), digest);
}

}  // namespace
}  // namespace gsbench::record
