// The limits of outlets beside clairvoyants, from both sides of each.
#include <gmock/gmock.h>

#include <fleet/limits.hpp>

namespace gsbench::fleet {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

ClosedLoopResult result_with(double nadir_hz, double shed_mw, std::size_t false_events = 0) {
  ClosedLoopResult result;
  result.nadir_hz = nadir_hz;
  result.shed_mw = shed_mw;
  result.outlets.emplace(1000.0);
  result.outlets->false_events = false_events;
  return result;
}

// The limits are 49.38 Hz, and 240 MW.
const ClosedLoopLimits kLimits = limits_of(profile::Plan(), Clairvoyants{49.40, 200.0});

TEST(ClosedLoopLimits, TheWorstClairvoyantCounts) {
  const auto all = clairvoyants_of({{Strategy::kNone, result_with(48.0, 0.0)},
                                    {Strategy::kCentral, result_with(48.5, 900.0)},
                                    {Strategy::kClairvoyant300ms, result_with(49.50, 150.0)},
                                    {Strategy::kClairvoyant500ms, result_with(49.45, 200.0)},
                                    {Strategy::kClairvoyant960ms, result_with(49.40, 180.0)}});
  EXPECT_EQ(all.value().lowest_nadir_hz, 49.40);
  EXPECT_EQ(all.value().most_shed_mw, 200.0);
}

TEST(ClosedLoopLimits, NeedAClairvoyant) {
  EXPECT_FALSE(clairvoyants_of(
      {{Strategy::kNone, result_with(48.0, 0.0)}, {Strategy::kClairvoyant300ms, std::nullopt}}));
}

TEST(ClosedLoopLimits, TheNadirMayBe20MillihertzLower) {
  EXPECT_THAT(missed_limits(result_with(49.3801, 200.0), kLimits), IsEmpty());
  EXPECT_THAT(missed_limits(result_with(49.3799, 200.0), kLimits),
              ElementsAre(AllOf(HasSubstr("nadir"), HasSubstr("below 49.380 Hz"))));
}

TEST(ClosedLoopLimits, ThePowerShedMayBe15PercentAnd10MegawattsMore) {
  EXPECT_THAT(missed_limits(result_with(49.4, 239.9), kLimits), IsEmpty());
  EXPECT_THAT(missed_limits(result_with(49.4, 240.1), kLimits),
              ElementsAre("240.1 MW shed is more than 240.0 MW"));
}

TEST(ClosedLoopLimits, NothingMayBeShedWhereNoClairvoyantSheds) {
  const ClosedLoopLimits limits = limits_of(profile::Plan(), Clairvoyants{49.6, 0.0});
  EXPECT_THAT(missed_limits(result_with(49.6, 0.0), limits), IsEmpty());
  EXPECT_THAT(missed_limits(result_with(49.6, 0.01), limits), SizeIs(1));
  const ClosedLoopLimits with_need = limits_of(profile::Plan(), Clairvoyants{49.6, 0.06});
  EXPECT_THAT(missed_limits(result_with(49.6, 10.0), with_need), IsEmpty());
}

TEST(ClosedLoopLimits, NoOutletMayClaimAFalseEventUnlessAnOscillationChangesTheFrequency) {
  EXPECT_THAT(missed_limits(result_with(49.4, 200.0, 1), kLimits), ElementsAre(HasSubstr(": 1")));
  profile::Plan plan;
  plan.stimulus.oscillations.resize(1);
  const ClosedLoopLimits limits = limits_of(plan, Clairvoyants{49.40, 200.0});
  EXPECT_THAT(missed_limits(result_with(49.4, 200.0, 1000), limits), IsEmpty());
  EXPECT_THAT(missed_limits(result_with(49.3, 241.0, 1000), limits), SizeIs(2));
}

TEST(ClosedLoopLimits, AllMissedOnesAreStated) {
  EXPECT_THAT(missed_limits(result_with(49.3, 241.0, 2), kLimits), SizeIs(3));
}

}  // namespace
}  // namespace gsbench::fleet
