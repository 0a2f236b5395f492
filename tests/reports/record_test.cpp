#include "fields.hpp"
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

TEST(Verdict, MaxIsTheWorseOfTwo) {
  EXPECT_EQ(std::max(Verdict::kPass, Verdict::kInconclusive), Verdict::kInconclusive);
  EXPECT_EQ(std::max(Verdict::kFail, Verdict::kInconclusive), Verdict::kFail);
  EXPECT_EQ(std::max(Verdict::kFail, Verdict::kError), Verdict::kError);
}

// Changes a field of any type.
template <class Value>
void change(Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    value += 'x';
  } else if constexpr (std::is_same_v<Value, Verdict>) {
    value = value == Verdict::kPass ? Verdict::kFail : Verdict::kPass;
  } else if constexpr (std::is_same_v<Value, double>) {
    value = std::isnan(value) ? 0.0 : std::nextafter(value, 1e300);
  } else if constexpr (std::is_arithmetic_v<Value>) {
    value = static_cast<Value>(value == 0);
  } else {
    value.pop_back();
  }
}

// `find`: the part of a run whose fields are changed, one at a time.
template <class Find>
void expect_each_field_counts(Find&& find) {
  RunRecord original = sample::loss_500mw(2);
  using Part = std::remove_reference_t<decltype(find(original))>;
  std::size_t fields = 0;
  visit_fields<Part>(find(original), [&](const char*, auto&) { ++fields; });
  for (std::size_t i = 0; i < fields; ++i) {
    RunRecord changed = original;
    std::string name;
    visit_fields<Part>(find(changed), [&, at = std::size_t{0}](const char* of, auto& it) mutable {
      if (at++ != i) {
        return;
      }
      change(it);
      name = of;
    });
    const bool is_no_content = name == "run_id" || name == "started_utc" ||
                               name == "finished_utc" || name == "software" ||
                               name == "content_sha256";
    EXPECT_EQ(content_digest(changed) == content_digest(original), is_no_content) << name;
  }
}

TEST(ContentDigest, ChangesWithEveryFieldExceptThoseOfOneExecution) {
  expect_each_field_counts([](auto& run) -> auto& { return run; });
  expect_each_field_counts([](auto& run) -> auto& { return run.comparisons[1]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.reference; });
  expect_each_field_counts([](auto& run) -> auto& { return run.stimulus[0]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1].measurements[3]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1].reports.marks[0]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1].reports.sent[0]; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1].reports.trace; });
  expect_each_field_counts([](auto& run) -> auto& { return run.outlets[1].reports.estimates; });
}

TEST(ContentDigest, ChangesWithTheOrderAndNumberOfParts) {
  const RunRecord original = sample::loss_500mw(2);
  const std::vector<std::function<void(RunRecord&)>> changes = {
      [](RunRecord& run) { run.outlets.pop_back(); },
      [](RunRecord& run) { std::swap(run.outlets[0], run.outlets[1]); },
      [](RunRecord& run) { run.outlets[1].settings["threshold_mw"] += 0.01; },
      // Text that moves from one field to the next is a change.
      [](RunRecord& run) {
        run.noise += run.firmware_sha256.front();
        run.firmware_sha256.erase(0, 1);
      },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    RunRecord changed = original;
    changes[i](changed);
    EXPECT_NE(content_digest(changed), content_digest(original)) << "change " << i;
  }
}

TEST(ContentDigest, TreatsAllNansAsEqual) {
  RunRecord run = sample::loss_500mw(1);
  run.outlets[0].reports.trace.frequency_hz[0] = std::numeric_limits<float>::quiet_NaN();
  const std::string digest = content_digest(run);
  run.outlets[0].reports.trace.frequency_hz[0] = -std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(content_digest(run), digest);
}

}  // namespace
}  // namespace gsbench::record
