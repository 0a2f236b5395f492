// Xiang et al., §6.1 and Table 1, by the command that prints them.
#include "gsbench_process.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using nlohmann::json;

TEST(Params, TheCalibratedGridGivesThePublishedThresholdAndConditions) {
  const Outcome outcome = run_gsbench({"params", "ieee24", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json params = json::parse(outcome.out);
  EXPECT_NEAR(params["threshold_mw"].get<double>(), 351.92, 0.1);
  const double published[] = {-0.3236, -0.2987, -0.2729, -0.2461, -0.2179,
                              -0.1879, -0.1557, -0.1200, -0.0779, 0.0};
  ASSERT_EQ(params["conditions"].size(), 10U);
  for (std::size_t row = 0; row < 10; ++row) {
    EXPECT_NEAR(params["conditions"][row]["rocof_below_hz_s"].get<double>(), published[row], 3e-4);
    EXPECT_NEAR(params["conditions"][row]["from_hz"].get<double>(),
                49.95 - 0.05 * static_cast<double>(row), 1e-9);
  }
}

TEST(Params, EveryKeyThatScriptsRelyOnIsThere) {
  for (const std::string grid : {"ieee24", "ieee24-by-unit", "island-60hz"}) {
    const json params = json::parse(run_gsbench({"params", grid, "--json"}).out);
    for (const std::string key :
         {"inertia_s", "droop_pu", "damping_pu", "gain_km", "reheat_fraction", "reheat_s",
          "base_mw", "omega_n", "zeta", "alpha", "omega_r", "phi", "phi1", "t_nadir_s",
          "threshold_mw", "k_lse_mw_per_hz_s", "conditions", "blocks"}) {
      EXPECT_TRUE(params.contains(key)) << grid << ": " << key;
    }
  }
}

TEST(Params, ThePublishedFiguresAndTheReasonForADifferenceStandBesideOurs) {
  const Outcome outcome = run_gsbench({"params", "ieee24"});
  for (const std::string text : {"3.761", "3.72", "351.92", "351.90", "-0.3236"}) {
    EXPECT_NE(outcome.out.find(text), std::string::npos) << text;
  }
  EXPECT_NE(outcome.out.find("Published: "), std::string::npos) << outcome.out;
}

}  // namespace
