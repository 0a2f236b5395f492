// How many files an addition touches (CONTRIBUTING.md), counted where the last such addition
// stands.
#include "tree.hpp"

#include <set>
#include <string>

#include <gmock/gmock.h>

namespace gsbench::arch {
namespace {

using testing::ElementsAre;

// Files of the product that name it, outside of `own_folder`.
std::set<std::string> files_that_name(const std::string& word,
                                      const std::string& own_folder = "-") {
  std::set<std::string> files;
  for (const auto& [path, content] : read_tree(GSBENCH_SOURCE_DIR)) {
    if (!starts_with(path, "tests/") && !starts_with(path, "profiles/") && is_cpp(path) &&
        !starts_with(path, own_folder) && content.find(word) != std::string::npos) {
      files.insert(path);
    }
  }
  return files;
}

TEST(Walk, AMeasureIsARowOfTheCatalogueAndItsReading) {
  EXPECT_THAT(files_that_name("\"relay.chatter\""),
              ElementsAre("bench/judge/relay_measures.cpp", "bench/measures/catalogue.cpp"));
}

TEST(Walk, AReportFormatIsItsFileAndARowOfTheTable) {
  EXPECT_THAT(files_that_name("junit"), ElementsAre("reports/render/include/render/render.hpp",
                                                    "reports/render/junit_xml.cpp"));
}

TEST(Walk, ASettingIsItsFieldItsRowTheRuleAndItsRowInProfiles) {
  EXPECT_THAT(files_that_name("event_departure_hz"),
              ElementsAre("bench/profile/outlets.cpp", "firmware/outlet/event_detector.cpp",
                          "firmware/outlet/include/outlet/event_detector.hpp",
                          "firmware/outlet/include/outlet/settings.hpp",
                          "firmware/outlet/include/outlet/settings_fields.hpp"));
}

TEST(Walk, ABoardIsItsFolderAndARowOfTheTable) {
  EXPECT_THAT(files_that_name("stm32f405", "firmware/boards/stm32f405/"),
              ElementsAre("firmware/boards/list/include/boards/boards.hpp"));
}

}  // namespace
}  // namespace gsbench::arch
