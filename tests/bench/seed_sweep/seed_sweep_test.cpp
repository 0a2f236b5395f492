#include <seed_sweep/seed_sweep.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <measures/catalogue.hpp>
#include <profile/load.hpp>
#include <station/run.hpp>

namespace gsbench::seed_sweep {
namespace {

using record::Verdict;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using Counts = std::map<Verdict, std::size_t>;
using Texts = std::map<std::string, std::size_t>;

// Two outlets, 1.5 s of noise.
profile::Plan parse(const std::string& expectations) {
  return profile::parse_profile(
      "title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
      "duration_s = 1.5\nnoise_pct = 1.0\n[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"b\"\n" +
          expectations,
      "test.toml");
}

profile::Plan quiet() {
  return parse("[[expect]]\nmeasure = \"event.count\"\nmax = 0\n");
}

profile::Plan half_failing() {
  return parse(
      "[[expect]]\nmeasure = \"event.count\"\nmax = 0\n"
      "[[expect]]\nmeasure = \"relay.end\"\nequals = \"open\"\noutlets = [\"b\"]\n");
}

StudyResult study_of(const profile::Plan& plan, std::uint64_t seeds, std::size_t threads = 1,
                     std::uint64_t first_seed = 1) {
  StudyOptions options;
  options.first_seed = first_seed;
  options.seeds = seeds;
  options.threads = threads;
  return study(plan, options);
}

const Row& row(const StudyResult& result, const std::string& measure) {
  const auto found = std::find_if(result.rows.begin(), result.rows.end(),
                                  [&](const Row& r) { return r.measure == measure; });
  if (found == result.rows.end()) {
    throw std::runtime_error("no row " + measure);
  }
  return *found;
}

// All contents of a result, with exact floating-point values.
std::string printed(const StudyResult& result) {
  std::string text = fmt::format("{} {:a} {} {}", result.seeds_done, result.hours,
                                 to_string(result.verdict), result.first_reason);
  const auto add_verdicts = [&text](const Counts& verdicts) {
    for (const auto& [verdict, count] : verdicts) {
      text += fmt::format(" {} {}", to_string(verdict), count);
    }
  };
  add_verdicts(result.verdicts);
  for (const auto& [measure, unit, values, verdicts, uncertainty] : result.rows) {
    text += fmt::format("\n{} [{}] {} {} {:a} {:a} {:a} {:a} {:a} {} {:a}", measure, unit,
                        values.count(), values.missing(), values.mean(),
                        values.standard_deviation(), values.quantile(0.0), values.quantile(0.5),
                        values.quantile(1.0), values.texts(), uncertainty);
    add_verdicts(verdicts);
  }
  return text;
}

TEST(Study, HasOneValueForEachOutletAndSeed) {
  const StudyResult result = study_of(quiet(), 3);
  EXPECT_EQ(result.seeds_done, 3U);
  EXPECT_DOUBLE_EQ(result.hours, 3 * 2 * 1.5 / 3600.0);
  EXPECT_EQ(result.verdict, Verdict::kPass);
  EXPECT_EQ(result.first_reason, "");
  EXPECT_EQ(result.verdicts, (Counts{{Verdict::kPass, 6}}));
  EXPECT_EQ(row(result, "tracker.error.rms").values.count(), 6U);
  EXPECT_EQ(row(result, "event.delay").values.missing(), 6U);
  EXPECT_EQ(row(result, "relay.end").values.texts(), (Texts{{"closed", 6}}));
  EXPECT_EQ(row(result, "event.count").verdicts, (Counts{{Verdict::kPass, 6}}));
  EXPECT_TRUE(row(result, "relay.edges").verdicts.empty()) << "no limit";
}

// Limits in other units and two limits on one measure: still one value for each outlet and seed.
TEST(Study, CountsEachOutletOnceWhateverItsLimits) {
  const StudyResult plain = study_of(quiet(), 2);
  const StudyResult limited =
      study_of(parse("[[expect]]\nmeasure = \"tracker.error.rms\"\nunit = \"Hz\"\nmax = 0.010\n"
                     "[[expect]]\nmeasure = \"tracker.error.rms\"\nunit = \"mHz\"\nmax = 1e-6\n"
                     "[[expect]]\nmeasure = \"relay.end\"\nequals = \"closed\"\n"
                     "[[expect]]\nmeasure = \"relay.end\"\nequals = \"closed\"\n"),
               2);
  EXPECT_EQ(limited.rows.size(), measures::catalogue().size());
  const Row& rms = row(limited, "tracker.error.rms");
  EXPECT_EQ(rms.unit, "mHz");
  EXPECT_EQ(rms.values.count(), 4U);
  // Two conversions by a factor of 1000 round twice.
  EXPECT_NEAR(rms.values.quantile(1.0), row(plain, "tracker.error.rms").values.quantile(1.0),
              1e-12);
  EXPECT_EQ(rms.verdicts, (Counts{{Verdict::kPass, 4}, {Verdict::kFail, 4}}));
  EXPECT_EQ(row(limited, "relay.end").values.texts(), (Texts{{"closed", 4}}));
}

TEST(Study, HasItsRowsInTheOrderOfTheCatalogue) {
  const StudyResult result = study_of(half_failing(), 1);
  ASSERT_EQ(result.rows.size(), measures::catalogue().size());
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    EXPECT_EQ(result.rows[i].measure, measures::catalogue()[i].name);
  }
}

TEST(Study, IsTheSameOnAnyNumberOfThreads) {
  const std::string one = printed(study_of(half_failing(), 7, 1));
  EXPECT_EQ(printed(study_of(half_failing(), 7, 2)), one);
  EXPECT_EQ(printed(study_of(half_failing(), 7, 3)), one);
  EXPECT_EQ(printed(study_of(half_failing(), 7, 12)), one) << "more threads than seeds";
}

TEST(Study, CombinesTheRunsOfItsSeeds) {
  profile::Plan plan = quiet();
  std::vector<double> rms_mhz;
  for (const std::uint64_t seed : {11U, 12U}) {
    plan.seed = seed;
    const auto station = station::simulated_station(plan, {});
    for (const record::OutletRecord& outlet : station::run(plan, *station, {}).outlets) {
      for (const record::MeasurementResult& result : outlet.measurements) {
        if (result.name == "tracker.error.rms") {
          rms_mhz.push_back(result.value);
        }
      }
    }
  }
  std::sort(rms_mhz.begin(), rms_mhz.end());
  ASSERT_EQ(rms_mhz.size(), 4U);
  EXPECT_EQ(std::set<double>(rms_mhz.begin(), rms_mhz.end()).size(), 4U)
      << "each outlet and seed has its own noise";
  const StudyResult result = study_of(quiet(), 2, 1, 11);
  const Distribution& values = row(result, "tracker.error.rms").values;
  for (std::size_t i = 0; i < rms_mhz.size(); ++i) {
    EXPECT_EQ(values.quantile(static_cast<double>(i + 1) / 4.0), rms_mhz[i]);
  }
}

TEST(Study, ReportsTheFirstFailureInOrderOfSeeds) {
  for (const std::size_t threads : {1U, 3U}) {
    const StudyResult result = study_of(half_failing(), 5, threads, 20);
    EXPECT_EQ(result.verdict, Verdict::kFail);
    EXPECT_THAT(result.first_reason, StartsWith("seed 20, b, relay.end: "));
    EXPECT_EQ(result.verdicts, (Counts{{Verdict::kPass, 5}, {Verdict::kFail, 5}}));
    EXPECT_EQ(row(result, "relay.end").verdicts, (Counts{{Verdict::kFail, 5}}));
  }
}

TEST(Study, ReportsTheCompletedSeedsWhenStopped) {
  for (const std::size_t threads : {1U, 3U}) {
    std::atomic<bool> stop{false};
    StudyOptions options;
    options.seeds = 1000;
    options.threads = threads;
    options.stop = &stop;
    options.progress = [&](std::uint64_t done, std::uint64_t) { stop = stop || done >= 4; };
    const StudyResult result = study(quiet(), options);
    EXPECT_EQ(result.seeds_done, 4U) << "seeds in progress when stopped do not count";
    EXPECT_EQ(row(result, "tracker.error.rms").values.count(), 8U);
    EXPECT_DOUBLE_EQ(result.hours, 4 * 2 * 1.5 / 3600.0);
    EXPECT_EQ(result.verdict, Verdict::kPass);
  }
}

TEST(Study, IsInconclusiveWhenStoppedBeforeTheFirstSeed) {
  const std::atomic<bool> stop{true};
  StudyOptions options;
  options.seeds = 5;
  options.stop = &stop;
  const StudyResult result = study(quiet(), options);
  EXPECT_EQ(result.seeds_done, 0U);
  EXPECT_TRUE(result.rows.empty());
  EXPECT_EQ(result.verdict, Verdict::kInconclusive);
  EXPECT_THAT(result.first_reason, HasSubstr("no seed"));
}

TEST(Study, ReportsItsProgressAfterEachSeed) {
  std::vector<std::uint64_t> reported_done;
  StudyOptions options;
  options.seeds = 6;
  options.threads = 3;
  options.progress = [&](std::uint64_t done, std::uint64_t all) {
    reported_done.push_back(done);
    EXPECT_EQ(all, 6U);
  };
  study(quiet(), options);
  EXPECT_EQ(reported_done, (std::vector<std::uint64_t>{1, 2, 3, 4, 5, 6}));
}

TEST(Study, RethrowsTheExceptionOfARun) {
  profile::Plan refused = quiet();
  refused.outlets[0].settings.settings["threshold_mw"] = -1.0;
  for (const std::size_t threads : {1U, 3U}) {
    EXPECT_THROW(study_of(refused, 5, threads), profile::ConfigurationError);
  }
}

}  // namespace
}  // namespace gsbench::seed_sweep
