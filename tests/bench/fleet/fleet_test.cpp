#include <numeric>
#include <stdexcept>

#include <gtest/gtest.h>

#include <fleet/fleet.hpp>

namespace {

using gsbench::control_centre::Accumulation;
using gsbench::fleet::Fleet;
using gsbench::fleet::FleetOptions;
using gsbench::fleet::make_fleet;
using gsbench::fleet::Shed;
using gsbench::fleet::shed_by_estimates;

constexpr float kThresholdMw = 351.92F;

// As many MW as the paper's, by fewer outlets that take more each.
Fleet small_fleet(Accumulation accumulation = Accumulation::kHalfGroup) {
  FleetOptions options;
  options.per_group = 20;
  options.least_w = 500.0;
  options.most_w = 90000.0;
  options.accumulation = accumulation;
  return make_fleet(options);
}

TEST(Fleet, HoldsItsGroupsInOrderWithTheirPower) {
  const Fleet fleet = small_fleet(Accumulation::kWholeGroup);
  ASSERT_EQ(fleet.outlets(), 20000U);
  ASSERT_EQ(fleet.groups(), 1000U);
  EXPECT_NEAR(std::accumulate(fleet.group_mw.begin(), fleet.group_mw.end(), 0.0), fleet.power_mw,
              1e-9);
  EXPECT_NEAR(fleet.power_mw, 905.0, 10.0);
  EXPECT_DOUBLE_EQ(fleet.accumulated_mw[0], fleet.group_mw[0]);  // eq. (11)
  EXPECT_NEAR(fleet.accumulated_mw.back(), fleet.power_mw, 1e-9);
  for (const float power_w : fleet.power_w) {
    ASSERT_GE(power_w, 500.0F);
    ASSERT_LE(power_w, 90000.0F);
  }
}

TEST(Fleet, ShedsByItsEstimatesUpToTheRequirement) {
  const Fleet fleet = small_fleet();
  const std::vector<float> exact(fleet.outlets(), 500.0F);
  const Shed shed = shed_by_estimates(fleet, exact, kThresholdMw);
  EXPECT_NEAR(shed.power_mw, 148.08, 0.5);  // to half a group
  EXPECT_EQ(shed.first_partly, shed.end_partly);
  EXPECT_EQ(shed.outlets, 20 * shed.first_partly);
  const std::vector<float> none(fleet.outlets(), 351.0F);
  EXPECT_EQ(shed_by_estimates(fleet, none, kThresholdMw).outlets, 0U);
}

TEST(Fleet, RefusesWhatMakesNoSense) {
  FleetOptions options;
  options.groups = 0;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
  options = {};
  options.per_group = 1000000;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
  options = {};
  options.least_w = 2000.0;
  EXPECT_THROW(make_fleet(options), std::invalid_argument);
}

}  // namespace
