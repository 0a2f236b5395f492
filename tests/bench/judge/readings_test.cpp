// Each measure of the catalogue is read by one row of the judge, and the judge reads no other.

#include <gmock/gmock.h>

#include <judge/reading.hpp>
#include <measures/catalogue.hpp>

namespace gsbench::judge {
namespace {

TEST(Readings, AreThoseOfTheCatalogue) {
  std::vector<std::string> catalogue;
  for (const measures::Measure& measure : measures::catalogue()) catalogue.push_back(measure.name);
  std::vector<std::string> readings;
  for (const auto& [name, read] : all_readings()) {
    EXPECT_EQ(reading_of(name), read) << name;
    readings.push_back(name);
  }
  EXPECT_THAT(readings, testing::UnorderedElementsAreArray(catalogue));
  EXPECT_THROW((void)reading_of("event.dela"), std::logic_error);
}

}  // namespace
}  // namespace gsbench::judge
