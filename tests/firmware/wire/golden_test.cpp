// A few messages byte by byte, so that the protocol cannot change unseen, and the README's
// examples, which are these.
#include "golden.hpp"

#include <wire_test/messages.hpp>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include <outlet/settings_fields.hpp>

namespace gs::wire::test {
namespace {

TEST(Golden, MessagesAreTheBytesTheyAlwaysWere) {
  for (const Golden& golden : goldens()) EXPECT_EQ(hex(golden.is), golden.was) << golden.name;
}

// The README's lines in ```hex blocks, joined up to the empty line or the end of the block.
std::set<std::string> examples_of_readme() {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/wire/README.md");
  EXPECT_TRUE(file.is_open());
  std::set<std::string> examples;
  std::string line;
  std::string example;
  bool within = false;
  while (std::getline(file, line)) {
    const bool fence = line.rfind("```", 0) == 0;
    if (!within) {
      within = line == "```hex";
      continue;
    }
    if (fence || line.empty()) {
      if (!example.empty()) examples.insert(example);
      example.clear();
      within = !fence;
      continue;
    }
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) example += (example.empty() ? "" : " ") + word;
  }
  return examples;
}

TEST(Golden, ExamplesInTheReadmeAreTrueBytes) {
  std::set<std::string> golden;
  for (const Golden& one : goldens()) golden.insert(one.was);
  EXPECT_EQ(examples_of_readme(), golden);
}

// "| 16 | lse_samples | u8 |": the settings' rows of the README, and no others.
TEST(Golden, SettingsInTheReadmeAreThoseOfTheList) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/wire/README.md");
  std::string line;
  while (std::getline(file, line) && line.rfind("| key | name", 0) != 0) {
  }
  std::getline(file, line);  // what is below the head
  const std::map<outlet::FieldType, std::string> types = {
      {outlet::FieldType::kU8, "u8"},
      {outlet::FieldType::kU16, "u16"},
      {outlet::FieldType::kU32, "u32"},
      {outlet::FieldType::kFloat, "f32"},
      {outlet::FieldType::kRows, "array of 2r"}};
  for (const outlet::Field& field : outlet::kSettingsFields) {
    std::getline(file, line);
    const std::string row =
        "| " + std::to_string(field.key) + " | " + field.name + " | " + types.at(field.type);
    EXPECT_EQ(line.substr(0, row.size()), row);
  }
  std::getline(file, line);
  EXPECT_EQ(line, "");
}

}  // namespace
}  // namespace gs::wire::test
