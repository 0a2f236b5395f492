// The shipped profiles and grids are valid, and are found by name and by path.
#include <profile_test/texts.hpp>
#include <test_support/environment.hpp>
#include <test_support/shipped_profiles.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

namespace gsbench::profile::test {
namespace {

namespace fs = std::filesystem;
using gsbench::test::Environment;
using gsbench::test::shipped_profiles;
using gsbench::test::TemporaryFolder;
using gsbench::test::test_name;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal_of_name(const std::string& name) {
  return gsbench::test::refusal_of<ConfigurationError>([&] { (void)load_profile(name); });
}

std::vector<std::string> profile_names() {
  std::vector<std::string> names;
  for (const ProfileSummary& summary : list_profiles()) {
    names.push_back(summary.name);
  }
  return names;
}

class Shipped : public testing::TestWithParam<std::string> {};

TEST_P(Shipped, LoadsUnderItsName) {
  const Plan plan = load_profile(GetParam());
  EXPECT_EQ(plan.name, GetParam());
  EXPECT_FALSE(plan.title.empty());
  EXPECT_GT(plan.duration_ticks(), 0);
  EXPECT_NO_THROW((void)plan.synthesizer());
}

TEST_P(Shipped, HasRelayLimitsForEveryOutlet) {
  const Plan plan = load_profile(GetParam());
  for (const Outlet& outlet : plan.outlets) {
    const auto limits = [&](const std::string& measure) {
      return std::any_of(
          plan.expectations.begin(), plan.expectations.end(), [&](const Expectation& expectation) {
            const auto& groups = expectation.groups;
            return expectation.measure == measure &&
                   (groups.empty() ||
                    std::find(groups.begin(), groups.end(), outlet.group) != groups.end());
          });
    };
    // Every profile must limit the final state of the relay and the number of its operations.
    EXPECT_TRUE(limits("relay.end")) << outlet.id;
    EXPECT_TRUE(limits("relay.edges")) << outlet.id;
  }
}

INSTANTIATE_TEST_SUITE_P(Profile, Shipped, testing::ValuesIn(shipped_profiles()), test_name);

TEST(ShippedProfiles, AreListedInAlphabeticalOrder) {
  const std::vector<std::string> names = profile_names();
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  EXPECT_THAT(names, testing::IsSupersetOf(shipped_profiles()));
  EXPECT_THAT(names,
              testing::IsSupersetOf({"cascades/three-losses", "disturbances/dips", "events/gb-2019",
                                     "paper/loss-500mw", "regression/steady"}));
}

// The set of `gsbench fleet --closed-loop --profile cascades`.
TEST(ShippedProfiles, HaveFortyCascades) {
  EXPECT_EQ(shipped_profiles("cascades/").size(), 40U);
}

TEST(ProfilesOfAFolder, AreFoundByNameAndByPath) {
  const std::vector<std::string> paper = {"paper/loss-320mw", "paper/loss-351.9mw",
                                          "paper/loss-500mw", "paper/loss-600mw"};
  for (const std::string name : {"paper", "paper/"}) {
    EXPECT_EQ(find_profile_or_folder(name).names, paper);
    EXPECT_TRUE(find_profile_or_folder(name).of_folder);
  }
  std::vector<std::string> paths;
  for (const std::string& path : find_profile_or_folder(profiles_folder() + "/paper").names) {
    paths.push_back(load_profile(path).name);
  }
  EXPECT_EQ(paths, paper);
}

TEST(ProfilesOfAFolder, AProfileIsFoundAlone) {
  for (const std::string name : {"paper/loss-500mw", "mine.toml"}) {
    EXPECT_THAT(find_profile_or_folder(name).names, testing::ElementsAre(name));
    EXPECT_FALSE(find_profile_or_folder(name).of_folder);
  }
}

TEST(ProfilesOfAFolder, GridsAndStationsAreLeftOut) {
  const FoundProfiles found = find_profile_or_folder(profiles_folder());
  EXPECT_TRUE(found.of_folder);
  std::vector<std::string> names;
  for (const std::string& path : found.names) {
    names.push_back(profile_name(path));
  }
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, shipped_profiles());
}

TEST(ProfilesOfAFolder, UnknownNamesAreRefused) {
  const auto refusal = [](const std::string& name) {
    return gsbench::test::refusal_of<ConfigurationError>(
        [&] { (void)find_profile_or_folder(name); });
  };
  EXPECT_THAT(refusal("cascade"),
              StartsWith("unknown profile or folder of profiles \"cascade\"; did you mean "
                         "\"cascades\"?"));
  EXPECT_THAT(refusal("nonesuch"), HasSubstr("; folders and profiles are: cascades, "));
  EXPECT_THAT(refusal("paper/loss"), StartsWith("unknown profile or folder of profiles"));
  EXPECT_THAT(refusal("grids"), StartsWith("unknown profile or folder of profiles"));
  EXPECT_THAT(refusal(""), StartsWith("unknown profile or folder of profiles"));
  const TemporaryFolder empty;
  EXPECT_EQ(refusal(empty.path().string()),
            empty.path().string() + ": no profile is in this folder");
}

TEST(ShippedProfiles, KeepTheirNamesWhenGivenByPath) {
  const std::string path = profiles_folder() + "/paper/loss-500mw.toml";
  EXPECT_EQ(load_profile(path).name, "paper/loss-500mw");
}

TEST(ShippedProfiles, AreSuggestedForAMisspeltName) {
  EXPECT_THAT(refusal_of_name("paper/loss-500"), HasSubstr("did you mean \"paper/loss-500mw\"?"));
  EXPECT_THAT(refusal_of_name("nonesuch"),
              HasSubstr("profiles are: cascades/deep-dip-at-the-loss, "));
  EXPECT_EQ(refusal_of_name("none/such.toml"), "none/such.toml: the profile file does not exist");
}

TEST(ShippedProfiles, DoNotIncludeGrids) {
  EXPECT_THAT(refusal_of_name("grids/ieee24"), StartsWith("unknown profile \"grids/ieee24\"; "));
}

TEST(ShippedGrids, AreListedAndValid) {
  std::vector<std::string> names;
  for (const ProfileSummary& summary : list_grids()) {
    names.push_back(summary.name);
    const grid::Grid grid = load_grid(summary.name);
    EXPECT_EQ(grid.name, summary.name);
    EXPECT_EQ(grid.title, summary.title);
  }
  EXPECT_THAT(names, testing::ElementsAre("ieee24", "ieee24-by-unit", "island-60hz"));
}

// $XDG_DATA_HOME with a folder of own profiles, for the length of a test.
class OwnProfiles : public testing::Test {
 protected:
  void SetUp() override {
    environment_.set("XDG_DATA_HOME", data_.path().c_str());
    for (const char* folder : {"mine", "paper", "grids"}) {
      fs::create_directories(profiles_ / folder);
    }
  }
  void write(const std::string& name) const {
    std::ofstream(profiles_ / (name + ".toml")) << kMinimal;
  }

  const TemporaryFolder data_;
  const fs::path profiles_ = data_.path() / "gsbench/profiles";
  Environment environment_;
};

TEST_F(OwnProfiles, AreFoundByNameBesideTheShippedOnes) {
  write("mine/case");
  EXPECT_EQ(load_profile("mine/case").name, "mine/case");
  EXPECT_THAT(profile_names(), testing::IsSupersetOf({"mine/case", "paper/loss-500mw"}));
}

TEST_F(OwnProfiles, WithAShippedNameAreRefusedByThatNameOnly) {
  write("paper/loss-500mw");
  EXPECT_THAT(refusal_of_name("paper/loss-500mw"), HasSubstr("have the same name; rename one"));
  EXPECT_EQ(load_profile("paper/loss-600mw").name, "paper/loss-600mw");
}

TEST_F(OwnProfiles, GridsAreFoundByName) {
  fs::copy_file(profiles_folder() + "/grids/ieee24.toml", profiles_ / "grids/own.toml");
  EXPECT_EQ(load_grid("own").name, "own");
  EXPECT_EQ(load_grid("ieee24").name, "ieee24");
}

TEST(ProfilesFolder, IsTakenFromTheEnvironment) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("mine"));
  fs::create_directory(folder.file("grids"));
  fs::copy_file(profiles_folder() + "/grids/ieee24.toml", folder.file("grids/own.toml"));
  folder.write("mine/case.toml", replaced(kMinimal, "ieee24", "own"));
  folder.write("mine/broken.toml", "title = ");
  Environment environment;
  environment.set("GSBENCH_PROFILES", folder.path().c_str());

  EXPECT_EQ(profiles_folder(), folder.path());
  EXPECT_EQ(load_profile("mine/case").grid.name, "own");
  const auto profiles = list_profiles();
  ASSERT_EQ(profiles.size(), 2u);
  EXPECT_EQ(profiles[0].name, "mine/broken");
  EXPECT_THAT(profiles[0].title, HasSubstr("broken.toml:1:"));
  EXPECT_EQ(profiles[1].title, "A test");
}

TEST(ProfilesFolder, IsRefusedIfItDoesNotExist) {
  Environment environment;
  environment.set("GSBENCH_PROFILES", "nowhere/at/all");
  const std::string message = "nowhere/at/all: the folder of profiles does not exist";
  EXPECT_THAT(refusal_of_name("paper/loss-500mw"), StartsWith(message));
  EXPECT_THROW(list_profiles(), ConfigurationError);
  EXPECT_THROW(list_grids(), ConfigurationError);
  EXPECT_EQ(profile_name("my/case.toml"), "case");
}

TEST(ProfileFile, IsRefusedUnreadIfItIsTooLarge) {
  const TemporaryFolder folder;
  const std::string path = folder.write("huge.toml", kMinimal);
  fs::resize_file(path, std::uintmax_t{1} << 40U);  // sparse
  EXPECT_EQ(refusal_of_name(path),
            path + ": the file has 1099511627776 bytes; it must have at most 4194304");
}

TEST(ProfileFile, IsRefusedIfItIsAFolder) {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("folder.toml"));
  EXPECT_EQ(refusal_of_name(folder.file("folder.toml")),
            folder.file("folder.toml") + ": the profile file does not exist");
}

}  // namespace
}  // namespace gsbench::profile::test
