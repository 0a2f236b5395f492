// profiles/README.md and the shipped files say what the declarations say.
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include <keys/markdown.hpp>
#include <profile/keys.hpp>
#include <station/station_file.hpp>

namespace gsbench::profile {
namespace {

std::string readme() {
  std::ifstream file(GSBENCH_SOURCE_DIR "/profiles/README.md");
  return {std::istreambuf_iterator<char>(file), {}};
}

void expect_printed(const std::string& format, const keys::Key& declared) {
  const std::string command = "gsbench schema " + format + " --markdown";
  const std::string text = readme();
  const std::string begin = "<!-- " + command + " -->\n";
  const auto from = text.find(begin);
  ASSERT_NE(from, std::string::npos) << begin;
  const auto to = text.find("<!-- end -->", from);
  ASSERT_NE(to, std::string::npos);
  EXPECT_EQ(text.substr(from + begin.size(), to - from - begin.size()), keys::markdown(declared))
      << "replace it by what `" << command << "` prints";
}

TEST(Readme, HoldsTheKeysOfAProfile) {
  expect_printed("profile", profile_keys());
}

TEST(Readme, HoldsTheKeysOfAGrid) {
  expect_printed("grid", grid_keys());
}

TEST(Readme, HoldsTheKeysOfAStation) {
  expect_printed("station", station::station_keys());
}

}  // namespace
}  // namespace gsbench::profile
