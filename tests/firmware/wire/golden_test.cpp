// A few messages byte by byte, so that the protocol cannot change unseen, and the README's
// examples, which are these.
#include "golden.hpp"

#include <wire_test/messages.hpp>

#include <fstream>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace gs::wire::test
