// Where the user's own files are: by the XDG Base Directory Specification.
#include <cstdlib>
#include <map>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include <installation/installation.hpp>

namespace gsbench::installation::test {
namespace {

// Sets or unsets environment variables for the length of a test.
class Environment {
 public:
  void set(const std::string& name, const char* value) {
    const char* before = std::getenv(name.c_str());
    before_.emplace(name, before != nullptr ? std::optional<std::string>(before) : std::nullopt);
    apply(name, value);
  }
  Environment() = default;
  ~Environment() {
    for (const auto& [name, value] : before_) {
      apply(name, value ? value->c_str() : nullptr);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  static void apply(const std::string& name, const char* value) {
    if (value != nullptr) {
      ::setenv(name.c_str(), value, 1);
    } else {
      ::unsetenv(name.c_str());
    }
  }

  std::map<std::string, std::optional<std::string>> before_;
};

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
