// The Iberian blackout of 28 April 2025 as a grid analyser in Toledo recorded it, every 2 s from
// 11:00:00: replayed where the recording is at hand.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <cstdlib>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

namespace fs = std::filesystem;
using gsbench::test::Outcome;
using gsbench::test::TemporaryFolder;

fs::path recording() {
  const char* folder = std::getenv("GSBENCH_RECORDED_DATA");
  return fs::path(folder != nullptr ? folder : GSBENCH_RECORDED_DATA) /
         "iberia-2025-04-28-toledo.csv";
}

// Seconds from 11:00:00.
constexpr const char* kLastOrdinarySampleS = "5596.0";  // 12:33:16
constexpr const char* kDeadBusS = "5604.0";             // 12:33:24

TEST(RecordedEvent, NoTripBeforeTheCollapseTheBackupInItAndNoFrequencyOnTheDeadBus) {
  if (!fs::exists(recording())) {
    GTEST_SKIP() << recording() << " is not here";
  }
  const TemporaryFolder folder;
  const std::string limits =
      std::string("[[expect]]\nmeasure = \"trip.time\"\nunit = \"s\"\nmin = ") +
      kLastOrdinarySampleS + "\nmax = " + kDeadBusS +
      "\n[[expect]]\nmeasure = \"decision.cause\"\nequals = \"frequency\"\n"
      "[[expect]]\nmeasure = \"validity.dead_bus_claims\"\nmax = 0\n"
      "[[expect]]\nmeasure = \"relay.edges\"\nmin = 1\nmax = 1\n";
  const std::string profile = folder.write(
      "toledo.toml",
      "title = \"Toledo, 28 April 2025\"\nsource = \"a grid analyser in Toledo\"\n[grid]\nsystem = "
      "\"ieee24\"\n[signal]\n"
      "noise_pct = 1.0\n[signal.trace]\nfile = \"" +
          recording().string() +
          "\"\ntime = \"time\"\nfrequency = \"AnalyzerL1Frequency\"\n"
          "voltage = \"AnalyzerL1PhaseVoltage\"\n[[outlet]]\ncount = 2\naccumulated_mw = 100.0\n"
          "switch_off_hz = 48.9\n" +
          limits);
  const Outcome outcome = gsbench::test::run_gsbench(
      {"run", profile, "--json", "--out", (folder.path() / "runs").string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto result = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(result["verdict"], "PASS") << outcome.out;
  EXPECT_EQ(result["outlets"].size(), 2U);
}

}  // namespace
