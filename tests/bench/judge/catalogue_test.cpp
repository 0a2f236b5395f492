#include <profile_test/catalogue.hpp>

#include <fstream>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <judge/catalogue.hpp>
#include <profile/units.hpp>

namespace gsbench::judge {
namespace {

TEST(Catalogue, NamesEachMeasureOnce) {
  std::set<std::string> names;
  for (const Measure& measure : catalogue()) {
    EXPECT_TRUE(names.insert(measure.name).second) << measure.name;
  }
  EXPECT_FALSE(names.empty());
}

TEST(Catalogue, DefinesEachMeasureInASentenceAndSaysWhatItNeeds) {
  for (const Measure& measure : catalogue()) {
    EXPECT_EQ(measure.definition.back(), '.') << measure.name;
    EXPECT_FALSE(measure.needs.empty()) << measure.name;
    EXPECT_NE(measure.read, nullptr) << measure.name;
  }
}

TEST(Catalogue, GivesEachMeasureAUnitThatConvertsOrItsWords) {
  for (const Measure& measure : catalogue()) {
    if (measure.is_word()) {
      EXPECT_EQ(measure.unit, "") << measure.name;
      EXPECT_GE(measure.words.size(), 2U) << measure.name;
    } else {
      EXPECT_EQ(profile::unit_scale(measure.unit, measure.unit), 1.0) << measure.name;
    }
  }
}

TEST(Catalogue, FindsItsMeasuresAndNoOthers) {
  for (const Measure& measure : catalogue()) EXPECT_EQ(find_measure(measure.name), &measure);
  EXPECT_EQ(find_measure("event.dela"), nullptr);
  EXPECT_EQ(find_measure(""), nullptr);
}

TEST(Catalogue, IsTheOneThatTheTestsOfProfilesUse) {
  const auto described = [](const profile::MeasureCatalogue& measures) {
    std::set<std::string> all;
    for (const profile::MeasureName& measure : measures) {
      std::string text = measure.name + " [" + measure.unit + "]";
      for (const std::string& word : measure.words) text += " " + word;
      all.insert(text + (measure.word ? " (word)" : ""));
    }
    return all;
  };
  EXPECT_EQ(described(measure_names()), described(profile::test::catalogue()));
}

TEST(Catalogue, HasWhatTheShippedProfilesExpect) {
  const std::vector<profile::ProfileSummary> shipped = profile::list_profiles();
  ASSERT_FALSE(shipped.empty());
  for (const profile::ProfileSummary& profile : shipped) {
    EXPECT_NO_THROW(profile::load_profile(profile.name, measure_names())) << profile.name;
  }
}

TEST(Catalogue, HasWhatTheDocumentationOfProfilesExpects) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/profiles/README.md");
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  const std::string key = "measure = \"";
  std::size_t found = 0;
  for (auto at = text.find(key); at != std::string::npos; at = text.find(key, at + 1)) {
    const auto from = at + key.size();
    const std::string name = text.substr(from, text.find('"', from) - from);
    EXPECT_NE(find_measure(name), nullptr) << name;
    ++found;
  }
  EXPECT_GE(found, 1U);
}

}  // namespace
}  // namespace gsbench::judge
