// Where the user's own files are: by the XDG Base Directory Specification.
#include <test_support/environment.hpp>

#include <gmock/gmock.h>

#include <installation/installation.hpp>

namespace gsbench::installation::test {
namespace {

using gsbench::test::Environment;

TEST(UserData, IsBelowXdgDataHome) {
  Environment environment;
  environment.set("XDG_DATA_HOME", "/data/anna");
  EXPECT_EQ(user_data("runs"), "/data/anna/gsbench/runs");
}

TEST(UserData, IsBelowHomeByDefault) {
  Environment environment;
  environment.set("HOME", "/data/bea");
  for (const char* ignored : {static_cast<const char*>(nullptr), "", "relative/path"}) {
    environment.set("XDG_DATA_HOME", ignored);
    EXPECT_EQ(user_data("profiles"), "/data/bea/.local/share/gsbench/profiles");
  }
}

TEST(UserData, IsEmptyWithoutAHome) {
  Environment environment;
  environment.set("XDG_DATA_HOME", nullptr);
  environment.set("HOME", nullptr);
  EXPECT_EQ(user_data("runs"), "");
}

TEST(Version, IsTheReleaseAndTheGitRevision) {
  EXPECT_THAT(version(),
              testing::MatchesRegex("[0-9]+\\.[0-9]+\\.[0-9]+( \\([0-9a-f]+(-dirty)?\\))?"));
}

}  // namespace
}  // namespace gsbench::installation::test
