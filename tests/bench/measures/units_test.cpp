#include <gmock/gmock.h>

#include <measures/units.hpp>

namespace gsbench::measures {
namespace {

TEST(Units, ConvertWithinADimension) {
  EXPECT_DOUBLE_EQ(unit_scale("s", "ms").value(), 1000.0);
  EXPECT_DOUBLE_EQ(unit_scale("ms", "s").value(), 0.001);
  EXPECT_DOUBLE_EQ(unit_scale("Hz", "mHz").value(), 1000.0);
  EXPECT_DOUBLE_EQ(unit_scale("GW", "MW").value(), 1000.0);
  EXPECT_DOUBLE_EQ(unit_scale("", "").value(), 1.0);
}

TEST(Units, DoNotConvertAcrossDimensions) {
  EXPECT_FALSE(unit_scale("s", "Hz"));
  EXPECT_FALSE(unit_scale("Hz", "Hz/s"));
  EXPECT_FALSE(unit_scale("", "%"));
  EXPECT_FALSE(unit_scale("pu", "V"));  // hangs on the nominal voltage
}

TEST(Units, UnknownOnesConvertIntoNothing) {
  EXPECT_FALSE(unit_scale("fortnight", "s"));
  EXPECT_FALSE(unit_scale("s", "S"));
  EXPECT_FALSE(unit_scale("fortnight", "fortnight"));
}

TEST(Units, ListThoseOfTheSameDimension) {
  EXPECT_THAT(units_like("Hz"), testing::ElementsAre("Hz", "mHz"));
  EXPECT_THAT(units_like("fortnight"), testing::IsEmpty());
}

}  // namespace
}  // namespace gsbench::measures
