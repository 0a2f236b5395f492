// Which station a file makes, and what of a plan is played on it.
#include "plans.hpp"

#include <gmock/gmock.h>

#include <station/station_file.hpp>

namespace gsbench::station {
namespace {

using test::plan;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr const char* kTwoGroups =
    "[[outlet]]\ncount = 3\nid = \"a\"\n[[outlet]]\ncount = 2\nid = \"b\"\n";

// With so many outlets.
class StationOf final : public StationFile {
 public:
  explicit StationOf(std::optional<std::size_t> outlets) : outlets_(outlets) { name = "station"; }
  std::optional<std::size_t> outlets() const override { return outlets_; }
  std::unique_ptr<Station> make_station(const profile::Plan&,
                                        const SimulatedOptions&) const override {
    return nullptr;
  }

 private:
  std::optional<std::size_t> outlets_;
};

std::vector<std::string> ids(const profile::Plan& plan) {
  std::vector<std::string> all;
  for (const profile::Outlet& outlet : plan.outlets) all.push_back(outlet.id);
  return all;
}

TEST(FitToStation, LeavesAPlanWhereThereAreOutletsEnough) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  EXPECT_EQ(ids(fit_to_station(StationOf(5), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(StationOf(9), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(StationOf(std::nullopt), asked)), ids(asked));
}

TEST(FitToStation, TakesOneOfEachGroupInTurnInThePlansOrder) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  const std::vector<std::string> all = ids(asked);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_THAT(ids(fit_to_station(StationOf(2), asked)), ElementsAre(all[0], all[3]));
  EXPECT_THAT(ids(fit_to_station(StationOf(3), asked)), ElementsAre(all[0], all[1], all[3]));
  EXPECT_THAT(ids(fit_to_station(StationOf(4), asked)),
              ElementsAre(all[0], all[1], all[3], all[4]));
}

TEST(FitToStation, RefusesMoreGroupsThanOutlets) {
  try {
    fit_to_station(StationOf(1), plan(1.0, "", kTwoGroups));
    FAIL() << "one outlet cannot be of two groups";
  } catch (const profile::ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("2 groups of outlets, and the station station only 1"));
  }
}

TEST(Stations, APhysicalOneIsRefusedForARunWithWhatItIsGoodFor) {
  try {
    (void)load_station("serial")->make_station(plan(1.0), {});
    FAIL() << "nothing plays to its outlets";
  } catch (const profile::ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("serial.toml: "));
    EXPECT_THAT(error.what(), HasSubstr("gsbench monitor"));
  }
}

TEST(Stations, ASimulatedOneCountsTheSourcesTicks) {
  EXPECT_TRUE(load_station("simulated")->make_station(plan(1.0), {})->outlets_count_ticks());
}

}  // namespace
}  // namespace gsbench::station
