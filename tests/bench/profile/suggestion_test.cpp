// Refusals of an unknown word help to find the right one.
#include <profile_test/texts.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::profile::test {
namespace {

using testing::HasSubstr;

TEST(Suggestion, NamesTheKeyOfWhichTheUnitWasForgotten) {
  EXPECT_THAT(refusal(replaced(kMinimal, "duration_s", "duration")),
              HasSubstr("did you mean \"duration_s\"?"));
}

TEST(Suggestion, NamesTheNearestOfSeveral) {
  EXPECT_THAT(refusal(replaced(kMinimal, "event.count", "tracker.eror.rms")),
              HasSubstr("did you mean \"tracker.error.rms\"?"));
}

TEST(Suggestion, ListsWhatThereIsWhereNothingIsNear) {
  EXPECT_THAT(refusal(replaced(kMinimal, "ieee24", "continental-europe")),
              HasSubstr("shipped grids are: ieee24, ieee24-by-unit"));
}

TEST(Suggestion, TakesNoLongerOnAnEndlessWord) {
  EXPECT_THAT(refusal(replaced(kMinimal, "event.count", std::string(1000000, 'x'))),
              HasSubstr("measures are: tracker.delay, "));
}

}  // namespace
}  // namespace gsbench::profile::test
