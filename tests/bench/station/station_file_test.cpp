// Station files: what they say, and what is refused, with the place.
#include "emulated_file.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include <station/station_file.hpp>

namespace gsbench::station {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class StationFiles : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::unique_ptr<StationFile> load(const std::string& text) const {
    std::ofstream(path()) << text;
    return load_station(path());
  }
  std::string refusal_of(const std::string& text) const {
    try {
      (void)load(text);
    } catch (const profile::ConfigurationError& error) {
      return error.what();
    }
    return {};
  }
  std::string path() const { return (folder_ / "hardware.toml").string(); }

  const fs::path folder_ =
      fs::path(testing::TempDir()) /
      ("stations-" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
};

constexpr const char* kEmulated = "title = \"A station\"\nkind = \"emulated\"\n";
constexpr const char* kPhysical = "title = \"A station\"\nkind = \"physical\"\n";

TEST_F(StationFiles, OfEmulatedOutletsTakesThemWithDefaults) {
  fs::create_directories(folder_);
  std::ofstream(folder_ / "my.elf") << "code";
  const auto file = load(std::string(kEmulated) +
                         "image = \"my.elf\"\n[[outlet]]\nid = \"a\"\n[[outlet]]\n"
                         "id = \"b\"\nboard = \"mps2-an386\"\nlink = \"serial\"\n"
                         "crystal_ppm = -40.0\n");
  EXPECT_EQ(file->name, "hardware");
  EXPECT_EQ(file->title, "A station");
  EXPECT_EQ(file->outlets(), 2U);
  EXPECT_FALSE(file->reachable());
  const auto& station = dynamic_cast<const EmulatedFile&>(*file);
  EXPECT_EQ(station.image, (folder_ / "my.elf").string());
  ASSERT_EQ(station.hardware.size(), 2U);
  EXPECT_EQ(station.hardware[0].board, "host");
  EXPECT_EQ(station.hardware[0].connection, emulation::Connection::kSerial);
  EXPECT_EQ(station.hardware[0].crystal_ppm, 0.0);
  EXPECT_EQ(station.hardware[1].id, "b");
  EXPECT_EQ(station.hardware[1].board, "mps2-an386");
  EXPECT_EQ(station.hardware[1].crystal_ppm, -40.0);
}

TEST_F(StationFiles, OfPhysicalOutletsSaysWhereTheyAre) {
  const auto file = load(std::string(kPhysical) +
                         "[serial]\nports = [\"/dev/ttyUSB0\", \"/dev/ttyUSB1\"]\n"
                         "baud = 115200\n[mqtt]\nurl = \"mqtts://b:8883\"\n"
                         "ca_file = \"ca.crt\"\nuser = \"u\"\n"
                         "password_file = \"pw\"\noutlets = [\"k-1\"]\n");
  ASSERT_TRUE(file->reachable());
  const PhysicalOutlets station = *file->reachable();
  EXPECT_THAT(station.serial_ports, ElementsAre("/dev/ttyUSB0", "/dev/ttyUSB1"));
  EXPECT_EQ(station.baud, 115200);
  EXPECT_EQ(station.broker.url, "mqtts://b:8883");
  EXPECT_EQ(station.broker.ca_file, (folder_ / "ca.crt").string());
  EXPECT_EQ(station.broker.password_file, (folder_ / "pw").string());
  EXPECT_THAT(station.broker.outlets, ElementsAre("k-1"));
}

TEST_F(StationFiles, NeedsNoCertificateWithoutTls) {
  const PhysicalOutlets station =
      *load(std::string(kPhysical) + "[mqtt]\nurl = \"mqtt://b:1883\"\n")->reachable();
  EXPECT_EQ(station.broker.ca_file, "");
  EXPECT_EQ(station.baud, 921600);
}

struct Refused {
  std::string text;
  std::string place;  // line:column
  std::string why;
};

TEST_F(StationFiles, IsRefusedWithThePlaceAndWhatWouldBeRight) {
  const std::string emulated = kEmulated;
  const std::string physical = kPhysical;
  std::string many = emulated;
  for (int i = 0; i < 65; ++i) many += "[[outlet]]\nid = \"o" + std::to_string(i) + "\"\n";
  const Refused all[] = {
      {"title = \"A\"\n", "1:1", "kind = "},
      {"title = \"A\"\nkind = \"real\"\n", "2:8", "simulated"},
      {"title = \"A\"\nkind = \"simulated\"\nspeed = 3\n", "3:1", "unknown key \"speed\""},
      {"title = \"A\"\nkind = \"simulated\"\nimage = \"x\"\n", "3:9", "means nothing"},
      {emulated, "1:1", "at least one [[outlet]]"},
      {emulated + "image = \"nowhere.elf\"\n[[outlet]]\nid = \"a\"\n", "3:9", "no such file"},
      {emulated + "[[outlet]]\nid = \"bench\"\n", "4:6", "called on its broker"},
      {emulated + "[[outlet]]\nid = \"a\"\nboard = \"mps2-an386\"\nlink = \"mqtt\"\n", "6:8",
       "no radio"},
      {emulated + "[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"a\"\n", "6:6", "already"},
      {emulated + "[[outlet]]\nid = \"a\"\n[serial]\nports = [\"p\"]\n", "5:1", "means nothing"},
      {many, "3:1", "more than 64"},
      {physical, "1:1", "[serial] or [mqtt]"},
      {physical + "[serial]\n", "3:1", "ports = "},
      {physical + "[mqtt]\nurl = \"http://b\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b:70000\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b:8883\"\n", "3:1", "ca_file"},
      {physical + "[mqtt]\nurl = \"mqtt://b:1883\"\noutlets = [\"a\", \"b+c/#\"]\n", "5:17",
       "letters, digits"},
      {physical + "[mqtt]\nurl = \"mqtt://b:1883\"\noutlets = [\"a\", \"a\"]\n", "5:17",
       "named already"},
      {physical + "[[outlet]]\nid = \"a\"\n", "3:1", "means nothing"},
  };
  for (const Refused& refused : all) {
    const std::string message = refusal_of(refused.text);
    EXPECT_THAT(message, StartsWith(path() + ":" + refused.place + ": ")) << refused.text;
    EXPECT_THAT(message, HasSubstr(refused.why)) << refused.text;
  }
}

TEST(Stations, AnUnknownNameIsToldWithTheNearest) {
  try {
    (void)load_station("emulatd");
    FAIL() << "no such station";
  } catch (const profile::ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"emulated\""));
  }
  EXPECT_THROW((void)load_station("nowhere/hardware.toml"), profile::ConfigurationError);
}

TEST(Stations, ThatAreShippedAreReadableAndNoProfiles) {
  const std::vector<profile::ProfileSummary> stations = list_stations();
  std::vector<std::string> names;
  for (const profile::ProfileSummary& station : stations) {
    names.push_back(station.name);
    EXPECT_NO_THROW((void)load_station(station.name)) << station.title;
  }
  EXPECT_THAT(names, ElementsAre("emulated", "mqtt", "serial", "simulated"));
  for (const profile::ProfileSummary& profile : profile::list_profiles()) {
    EXPECT_EQ(profile.name.rfind("stations/", 0), std::string::npos) << profile.name;
  }
}

}  // namespace
}  // namespace gsbench::station
