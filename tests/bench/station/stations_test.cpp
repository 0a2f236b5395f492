// Which station a file makes, and what of a plan is played on it.
#include "plans.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <station/stations.hpp>

namespace gsbench::station {
namespace {

using test::plan;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kTwoGroups =
    "[[outlet]]\ncount = 3\nid = \"a\"\n[[outlet]]\ncount = 2\nid = \"b\"\n";

profile::StationSpec emulated(std::size_t outlets) {
  profile::StationSpec spec;
  spec.kind = profile::StationKind::kEmulated;
  spec.name = "desk";
  for (std::size_t i = 0; i < outlets; ++i) {
    spec.emulated.push_back({"e" + std::to_string(i), "host", "serial", 0.0});
  }
  return spec;
}

std::vector<std::string> ids(const profile::Plan& plan) {
  std::vector<std::string> all;
  for (const profile::Outlet& outlet : plan.outlets) all.push_back(outlet.id);
  return all;
}

TEST(FitToStation, LeavesAPlanWhereThereAreOutletsEnough) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  EXPECT_EQ(ids(fit_to_station(emulated(5), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(emulated(9), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(profile::StationSpec(), asked)), ids(asked));
}

TEST(FitToStation, TakesOneOfEachGroupInTurnInThePlansOrder) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  const std::vector<std::string> all = ids(asked);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_THAT(ids(fit_to_station(emulated(2), asked)), ElementsAre(all[0], all[3]));
  EXPECT_THAT(ids(fit_to_station(emulated(3), asked)), ElementsAre(all[0], all[1], all[3]));
  EXPECT_THAT(ids(fit_to_station(emulated(4), asked)), ElementsAre(all[0], all[1], all[3], all[4]));
}

TEST(FitToStation, RefusesMoreGroupsThanOutlets) {
  try {
    fit_to_station(emulated(1), plan(1.0, "", kTwoGroups));
    FAIL() << "one outlet cannot be of two groups";
  } catch (const profile::ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 groups of outlets, and the station desk only 1"));
  }
}

TEST(Stations, APhysicalOneIsRefusedForARunWithWhatItIsGoodFor) {
  profile::StationSpec spec;
  spec.kind = profile::StationKind::kPhysical;
  spec.path = "hardware.toml";
  try {
    make_station(spec, plan(1.0), {});
    FAIL() << "nothing plays to its outlets";
  } catch (const profile::ConfigurationError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("hardware.toml: "));
    EXPECT_THAT(error.what(), HasSubstr("gsbench monitor"));
  }
}

TEST(Stations, ASimulatedOneCountsTheSourcesTicks) {
  EXPECT_TRUE(make_station(profile::StationSpec(), plan(1.0), {})->outlets_count_ticks());
}

}  // namespace
}  // namespace gsbench::station
