// No key can be forgotten by the loader or by the documentation: for each line of profiles that use
// every key, a value of a wrong type is refused on that line, and the key stands in the README.
#include <profile_test/texts.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

#include <gtest/gtest.h>

#include <profile/station_spec.hpp>

namespace gsbench::profile::test {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

class EveryKey : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "recording.csv") << "t,f,u\n0,50,230\n2,50,230\n4,50,230\n";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  const std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("gsbench-every-key-" + std::to_string(getpid()));
};

TEST_P(EveryKey, IsReadAndRefusedWhereItsTypeIsWrong) {
  const std::string path = (folder_ / "case.toml").string();
  const auto lines = lines_of(GetParam());
  ASSERT_EQ(refusal(GetParam(), path), "");
  int keys = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto equals = lines[i].find(" = ");
    if (equals == std::string::npos) continue;
    auto spoilt = lines;
    spoilt[i] = lines[i].substr(0, equals) + " = true";  // no key takes a boolean
    const std::string expected =
        path + ":" + std::to_string(i + 1) + ":" + std::to_string(equals + 4) + ": ";
    EXPECT_EQ(refusal(joined(spoilt), path).substr(0, expected.size()), expected) << spoilt[i];
    ++keys;
  }
  EXPECT_GT(keys, 5);
}

TEST_P(EveryKey, IsDocumented) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/profiles/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(readme.empty());
  for (const std::string& line : lines_of(GetParam())) {
    const auto equals = line.find(" = ");
    if (equals == std::string::npos) continue;
    EXPECT_NE(readme.find("| `" + line.substr(0, equals) + "` |"), std::string::npos) << line;
  }
}

INSTANTIATE_TEST_SUITE_P(OfAProfile, EveryKey,
                         testing::Values(kLossesInPlace, kPoints, kRecording));

constexpr const char* kEmulatedStation = R"(
title = "all keys of an emulated station"
kind = "emulated"
image = "outlet.elf"
[[outlet]]
id = "a"
board = "host"
link = "mqtt"
crystal_ppm = 20.0
)";
constexpr const char* kPhysicalStation = R"(
title = "all keys of a physical station"
kind = "physical"
[serial]
ports = ["/dev/ttyUSB0"]
baud = 115200
[mqtt]
url = "mqtts://broker.example:8883"
ca_file = "ca.crt"
user = "bench"
password_file = "password"
outlets = ["a"]
)";

TEST(Documentation, TheStationsItIsHeldAgainstAreAccepted) {
  const gsbench::test::TemporaryFolder folder;
  folder.write("outlet.elf", "code");
  EXPECT_NO_THROW((void)load_station(folder.write("emulated.toml", kEmulatedStation)));
  EXPECT_NO_THROW((void)load_station(folder.write("physical.toml", kPhysicalStation)));
}

TEST(Documentation, NamesNoKeyThatTheLoaderDoesNotKnow) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/profiles/README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const std::string all =
      std::string(kLossesInPlace) + kPoints + kRecording + kEmulatedStation + kPhysicalStation;
  const std::regex row(R"(\n\| `([a-z0-9_]+)` \|)");
  int keys = 0;
  for (std::sregex_iterator at(readme.begin(), readme.end(), row), end; at != end; ++at, ++keys) {
    EXPECT_NE(all.find("\n" + (*at)[1].str() + " = "), std::string::npos) << (*at)[1];
  }
  EXPECT_GT(keys, 40);
}

}  // namespace
}  // namespace gsbench::profile::test
