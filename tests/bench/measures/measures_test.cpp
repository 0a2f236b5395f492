#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>

#include <measures/catalogue.hpp>

namespace gsbench::measures {
namespace {

TEST(Catalogue, HasUniqueNames) {
  std::set<std::string> names;
  for (const Measure& measure : catalogue()) {
    EXPECT_TRUE(names.insert(measure.name).second) << measure.name;
  }
  EXPECT_FALSE(names.empty());
}

TEST(Catalogue, HasADefinitionAndTheNeedsOfEachMeasure) {
  for (const Measure& measure : catalogue()) {
    EXPECT_EQ(measure.definition.back(), '.') << measure.name;
    EXPECT_FALSE(measure.needs.empty()) << measure.name;
  }
}

TEST(Catalogue, HasAKnownUnitOrTextValuesForEachMeasure) {
  for (const Measure& measure : catalogue()) {
    if (measure.is_text()) {
      EXPECT_EQ(measure.unit, "") << measure.name;
      EXPECT_GE(measure.text_values.size(), 2U) << measure.name;
    } else {
      EXPECT_EQ(unit_scale(measure.unit, measure.unit), 1.0) << measure.name;
    }
  }
}

TEST(Catalogue, FindsExactlyItsOwnMeasures) {
  for (const Measure& measure : catalogue()) {
    EXPECT_EQ(find(measure.name), &measure);
  }
  EXPECT_EQ(find("event.dela"), nullptr);
  EXPECT_EQ(find(""), nullptr);
}

TEST(Catalogue, HasEveryMeasureNamedInTheProfileReadme) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/profiles/README.md");
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string key = "measure = \"";
  std::size_t found = 0;
  for (auto at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const auto from = at + key.size();
    const std::string name = text.substr(from, text.find('"', from) - from);
    EXPECT_NE(find(name), nullptr) << name;
    ++found;
  }
  EXPECT_GE(found, 1U);
}

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
  EXPECT_FALSE(unit_scale("pu", "V"));  // depends on the nominal voltage
}

TEST(Units, DoNotConvertIfUnknown) {
  EXPECT_FALSE(unit_scale("fortnight", "s"));
  EXPECT_FALSE(unit_scale("s", "S"));
  EXPECT_FALSE(unit_scale("fortnight", "fortnight"));
}

TEST(Units, ListUnitsOfTheSameDimension) {
  EXPECT_THAT(units_like("Hz"), testing::ElementsAre("Hz", "mHz"));
  EXPECT_THAT(units_like("fortnight"), testing::IsEmpty());
}

}  // namespace
}  // namespace gsbench::measures
