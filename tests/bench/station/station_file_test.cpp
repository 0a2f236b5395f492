// Station files: their contents, refusals with line and column, the stations they describe, and the
// reduction of a plan to a station.
#include "emulated_station.hpp"
#include "plans.hpp"
#include <test_support/refusal.hpp>
#include <test_support/temporary_folder.hpp>

#include <array>

#include <gmock/gmock.h>

#include <station/station_file.hpp>

namespace gsbench::station {
namespace {

using test::plan;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class StationFiles : public testing::Test {
 protected:
  StationFile load(const std::string& text) const {
    return load_station(folder_.write("hardware.toml", text));
  }

  const gsbench::test::TemporaryFolder folder_;
};

template <class Call>
std::string refusal_of(const Call& call) {
  return gsbench::test::refusal_of<profile::ConfigurationError>(call);
}

constexpr const char* kEmulated = "title = \"A station\"\nkind = \"emulated\"\n";
constexpr const char* kPhysical = "title = \"A station\"\nkind = \"physical\"\n";
const std::string kSource =
    "[source]\nkind = \"scpi\"\nport = \"tcp://127.0.0.1:1\"\ninstrument = \"siglent-sdg2000x\"\n"
    "gain = 100.0\nvoltage_limit_v = 265.0\nboot_s = 12.0\n";

TEST_F(StationFiles, OfEmulatedOutletsHaveDefaults) {
  const std::string image = folder_.write("my.elf", "code");
  const std::string text = std::string(kEmulated) +
                           "image = \"my.elf\"\n[[outlet]]\nid = \"a\"\n[[outlet]]\n"
                           "id = \"b\"\nboard = \"mps2-an386\"\nlink = \"serial\"\n"
                           "crystal_ppm = -40.0\n";
  const StationFile file = load(text);
  EXPECT_EQ(file.name, "hardware");
  EXPECT_EQ(file.title, "A station");
  EXPECT_EQ(file.outlets, 2U);
  EXPECT_FALSE(file.reachable);
  const keys::Document document = keys::parse_toml(text, file.path);
  const auto station = read_emulated(keys::Table(document, station_keys("emulated")), file.path);
  EXPECT_EQ(station.image, image);
  ASSERT_EQ(station.outlets.size(), 2U);
  EXPECT_EQ(station.outlets[0].board, "host");
  EXPECT_EQ(station.outlets[0].connection, emulation::Connection::kSerial);
  EXPECT_EQ(station.outlets[0].crystal_ppm, 0.0);
  EXPECT_EQ(station.outlets[1].id, "b");
  EXPECT_EQ(station.outlets[1].board, "mps2-an386");
  EXPECT_EQ(station.outlets[1].crystal_ppm, -40.0);
}

TEST_F(StationFiles, OfEmulatedOutletsMayHaveContactOnlyDevices) {
  const std::string text = std::string(kEmulated) +
                           "[[outlet]]\nid = \"a\"\nboard = \"frequency-relay\"\n"
                           "pickup_hz = 48.7\ndelay_s = 0.2\n"
                           "[[outlet]]\nid = \"b\"\nboard = \"frequency-relay\"\nlink = \"none\"\n";
  const StationFile file = load(text);
  const keys::Document document = keys::parse_toml(text, file.path);
  const auto station = read_emulated(keys::Table(document, station_keys("emulated")), file.path);
  ASSERT_EQ(station.outlets.size(), 2U);
  for (const emulation::HardwareOutlet& outlet : station.outlets) {
    EXPECT_EQ(outlet.connection, emulation::Connection::kNone);
    ASSERT_TRUE(outlet.frequency_relay);
  }
  EXPECT_EQ(station.outlets[0].frequency_relay->pickup_hz, 48.7);
  EXPECT_EQ(station.outlets[0].frequency_relay->delay_s, 0.2);
  EXPECT_EQ(station.outlets[1].frequency_relay->pickup_hz, 49.0);
}

TEST_F(StationFiles, OfPhysicalOutletsDescribeTheirLinks) {
  const auto file = load(std::string(kPhysical) +
                         "[serial]\nports = [\"/dev/ttyUSB0\", \"/dev/ttyUSB1\"]\n"
                         "baud = 115200\n[mqtt]\nurl = \"mqtts://b:8883\"\n"
                         "ca_file = \"ca.crt\"\nuser = \"u\"\n"
                         "password_file = \"pw\"\noutlets = [\"k-1\"]\n");
  ASSERT_TRUE(file.reachable);
  const PhysicalOutlets station = *file.reachable;
  EXPECT_THAT(station.serial.ports, ElementsAre("/dev/ttyUSB0", "/dev/ttyUSB1"));
  EXPECT_EQ(station.serial.baud, 115200);
  EXPECT_EQ(station.mqtt.url, "mqtts://b:8883");
  EXPECT_EQ(station.mqtt.ca_file, folder_.file("ca.crt"));
  EXPECT_EQ(station.password_file, folder_.file("pw"));
  EXPECT_THAT(station.mqtt.outlets, ElementsAre("k-1"));
}

TEST_F(StationFiles, OfSlotsAreReachedByTheLinksOfTheSlots) {
  const auto file =
      load(std::string(kPhysical) +
           "[serial]\nbaud = 9600\n[mqtt]\nurl = \"mqtt://b:1883\"\n[[outlet]]\nplace = \"a\"\n"
           "link = \"/dev/ttyUSB0\"\n[[outlet]]\nplace = \"b\"\nserial_number = \"GS-7\"\n"
           "link = \"mqtt\"\n");
  EXPECT_EQ(file.outlets, 2U);
  ASSERT_TRUE(file.reachable);
  EXPECT_THAT(file.reachable->serial.ports, ElementsAre("/dev/ttyUSB0"));
  EXPECT_EQ(file.reachable->serial.baud, 9600);
  EXPECT_EQ(file.reachable->mqtt.url, "mqtt://b:1883");
  EXPECT_THAT(file.reachable->mqtt.outlets, ElementsAre("GS-7"));
}

TEST_F(StationFiles, OfSlotsDoNotUseABrokerWithoutOutlets) {
  const auto file = load(std::string(kPhysical) +
                         "[mqtt]\nurl = \"mqtt://b:1883\"\n[[outlet]]\nplace = \"a\"\n"
                         "link = \"/dev/ttyUSB0\"\n");
  EXPECT_EQ(file.reachable->mqtt.url, "");
}

TEST_F(StationFiles, NeedNoCertificateWithoutTls) {
  const PhysicalOutlets station =
      *load(std::string(kPhysical) + "[mqtt]\nurl = \"mqtt://b:1883\"\n").reachable;
  EXPECT_EQ(station.mqtt.ca_file, "");
  EXPECT_EQ(station.serial.baud, 921600);
}

TEST_F(StationFiles, AreRefusedWithLineColumnAndReason) {
  const std::string emulated = kEmulated;
  const std::string physical = kPhysical;
  std::string many = emulated;
  for (int i = 0; i < 65; ++i) {
    many += "[[outlet]]\nid = \"o" + std::to_string(i) + "\"\n";
  }
  // The text; line and column of the error; part of the message.
  const std::array<std::string, 3> all[] = {
      {"title = \"A\"\n", "1:1", "kind = "},
      {"title = \"A\"\nkind = \"real\"\n", "2:8", "simulated"},
      {"title = \"A\"\nkind = \"simulated\"\nspeed = 3\n", "3:1", "unknown key \"speed\""},
      {"title = \"A\"\nkind = \"simulated\"\nimage = \"x\"\n", "3:9", "is not a key of a station"},
      {emulated, "1:1", "at least one [[outlet]]"},
      {emulated + "image = \"nowhere.elf\"\n[[outlet]]\nid = \"a\"\n", "3:9",
       "not an existing file"},
      {emulated + "[[outlet]]\nid = \"bench\"\n", "4:6", "user name of the bench"},
      {emulated + "[[outlet]]\nid = \"a\"\nboard = \"mps2-an386\"\nlink = \"mqtt\"\n", "6:8",
       "no radio"},
      {emulated + "[[outlet]]\nid = \"a\"\n[[outlet]]\nid = \"a\"\n", "6:6", "used twice"},
      {emulated + "[[outlet]]\nid = \"a\"\nboard = \"frequency-relay\"\nlink = \"mqtt\"\n", "6:8",
       "has only a contact"},
      {emulated + "[[outlet]]\nid = \"a\"\nlink = \"none\"\n", "5:8", "reports over its link"},
      {emulated + "[[outlet]]\nid = \"a\"\ndelay_s = 0.1\n", "5:11", "frequency-relay\" only"},
      {emulated + "[[outlet]]\nid = \"a\"\n[serial]\nports = [\"p\"]\n", "5:1",
       "is not a key of a station"},
      {many, "3:1", "at most 64"},
      {physical, "1:1", "[serial] or [mqtt]"},
      {physical + "[serial]\n", "3:1", "ports = "},
      {physical + kSource + "[[outlet]]\nplace = \"a\"\nrelay = \"/dev/ttyUSB0 CTS\"\n", "12:9",
       "has no relay sense; add [relay]"},
      {physical + kSource, "1:1", "at least one [[outlet]]"},
      {physical + "[mqtt]\nurl = \"http://b\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b:70000\"\n", "4:7", "mqtts://host:port"},
      {physical + "[mqtt]\nurl = \"mqtts://b:8883\"\n", "3:1", "ca_file"},
      {physical + "[mqtt]\nurl = \"mqtt://b:1883\"\noutlets = [\"a\", \"b+c/#\"]\n", "5:17",
       "letters, digits"},
      {physical + "[mqtt]\nurl = \"mqtt://b:1883\"\noutlets = [\"a\", \"a\"]\n", "5:17",
       "listed twice"},
      {physical + "[[outlet]]\nid = \"a\"\n", "4:1", "unknown key \"id\" in [[outlet]]"},
      {physical + "image = \"x\"\n[mqtt]\nurl = \"mqtt://b:1\"\n", "3:9",
       "is not a key of a station of kind \"physical\""},
      {physical + "[[outlet]]\nplace = \"a\"\n", "3:1", "the channel that senses its contact"},
      {physical + "[[outlet]]\nplace = \"a\"\nlink = \"mqtt\"\n", "3:1", "the id of the outlet"},
      {physical + "[[outlet]]\nplace = \"a\"\nserial_number = \"a\"\nlink = \"mqtt\"\n", "6:8",
       "the station has no broker; add [mqtt]"},
      {physical +
           "[[outlet]]\nplace = \"a\"\nlink = \"/p\"\n[[outlet]]\nplace = \"a\"\nlink = \"/q\"\n",
       "7:9", "must be unique"},
      {physical +
           "[[outlet]]\nplace = \"a\"\nlink = \"/p\"\n[[outlet]]\nplace = \"b\"\nlink = \"/p\"\n",
       "8:8", "must be unique"},
      {physical + "[[outlet]]\nplace = \"a\"\nlink = \"/p\"\n[[outlet]]\nplace = \"b\"\n"
                  "serial_number = \"a\"\nlink = \"/q\"\n",
       "8:17", "must be unique"},
      {physical + "[serial]\nports = [\"/p\"]\n[[outlet]]\nplace = \"a\"\nlink = \"/q\"\n", "4:9",
       "as the link of its [[outlet]]"},
      {physical + "[mqtt]\nurl = \"mqtt://b:1\"\noutlets = [\"x\"]\n[[outlet]]\nplace = \"a\"\n"
                  "link = \"/q\"\n",
       "5:11", "as an [[outlet]] with link"},
  };
  for (const auto& [text, place, message] : all) {
    EXPECT_THAT(
        refusal_of([&, text = text] { (void)load(text); }),
        AllOf(StartsWith(folder_.file("hardware.toml") + ":" + place + ": "), HasSubstr(message)))
        << text;
  }
}

TEST_F(StationFiles, RequireSchemeHostAndPortOfABroker) {
  const auto mqtt = [](const std::string& url) {
    const bool uses_tls = url.rfind("mqtt:", 0) != 0;
    return std::string(kPhysical) + "[mqtt]\n" + (uses_tls ? "ca_file = \"ca.crt\"\n" : "") +
           "url = \"" + url + "\"\n";
  };
  for (const char* url : {"mqtt://b:1", "mqtts://b:65535", "mqtts://[fe80::1]:8883"}) {
    EXPECT_EQ(load(mqtt(url)).reachable->mqtt.url, url);
  }
  EXPECT_EQ(load(mqtt("MQTTS://[::1]:08883/")).reachable->mqtt.url, "mqtts://[::1]:8883");
  for (const std::string& url :
       {std::string("mqtt://:1883"), std::string("mqtt://b:"), std::string("mqtt://b:0"),
        std::string("mqtt://b:001883"), std::string("mqtt://::1:1883"),
        std::string("mqtt://b/c:1883"), std::string("mqtt://b:1:2"), std::string("mqtt://b:+1"),
        std::string("mqttx://b:1883"), std::string(" mqtt://b:1883"),
        "mqtt://" + std::string(300, 'b') + ":1883"}) {
    EXPECT_NE(refusal_of([&] { (void)load(mqtt(url)); }), "") << url;
  }
}

TEST_F(StationFiles, RefuseKeysOfABrokerThatHaveNoEffect) {
  const std::string mqtt = std::string(kPhysical) + "[mqtt]\nurl = \"mqtt://b:1\"\n";
  EXPECT_THAT(refusal_of([&] { (void)load(mqtt + "ca_file = \"ca.crt\"\n"); }),
              HasSubstr("ca_file has no effect with mqtt://; for TLS use mqtts://"));
  EXPECT_THAT(refusal_of([&] { (void)load(mqtt + "password_file = \"pw\"\n"); }),
              HasSubstr("password_file has no effect without user"));
}

TEST(Stations, UnknownNameIsRefusedWithTheNearestName) {
  EXPECT_THAT(refusal_of([] { (void)load_station("emulatd"); }), HasSubstr("\"emulated\""));
  EXPECT_NE(refusal_of([] { (void)load_station("nowhere/hardware.toml"); }), "");
}

TEST(Stations, ShippedOnesAreReadableAndAreNotListedAsProfiles) {
  const std::vector<profile::ProfileSummary> stations = list_stations();
  std::vector<std::string> names;
  for (const profile::ProfileSummary& station : stations) {
    names.push_back(station.name);
    EXPECT_NO_THROW((void)load_station(station.name)) << station.title;
  }
  EXPECT_THAT(names, ElementsAre("contact-only", "emulated", "generator", "generator-contact-only",
                                 "head", "head-contact-only", "head-emulated", "mqtt",
                                 "scpi-emulated", "serial", "simulated"));
  for (const profile::ProfileSummary& profile : profile::list_profiles()) {
    EXPECT_EQ(profile.name.rfind("stations/", 0), std::string::npos) << profile.name;
  }
}

constexpr const char* kTwoGroups =
    "[[outlet]]\ncount = 3\nid = \"a\"\n[[outlet]]\ncount = 2\nid = \"b\"\n";

// A station with this number of outlets.
StationFile station_of(std::optional<std::size_t> outlets) {
  return {"station", "", "", "", outlets};
}

std::vector<std::string> ids(const profile::Plan& plan) {
  std::vector<std::string> all;
  for (const profile::Outlet& outlet : plan.outlets) {
    all.push_back(outlet.id);
  }
  return all;
}

TEST(FitToStation, KeepsAPlanIfThereAreEnoughOutlets) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  EXPECT_EQ(ids(fit_to_station(station_of(5), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(station_of(9), asked)), ids(asked));
  EXPECT_EQ(ids(fit_to_station(station_of(std::nullopt), asked)), ids(asked));
}

TEST(FitToStation, SelectsOutletsRoundRobinOverTheGroups) {
  const profile::Plan asked = plan(1.0, "", kTwoGroups);
  const std::vector<std::string> all = ids(asked);
  ASSERT_EQ(all.size(), 5U);
  EXPECT_THAT(ids(fit_to_station(station_of(2), asked)), ElementsAre(all[0], all[3]));
  EXPECT_THAT(ids(fit_to_station(station_of(3), asked)), ElementsAre(all[0], all[1], all[3]));
  EXPECT_THAT(ids(fit_to_station(station_of(4), asked)),
              ElementsAre(all[0], all[1], all[3], all[4]));
}

TEST(FitToStation, RefusesMoreGroupsThanOutlets) {
  EXPECT_THAT(refusal_of([] { fit_to_station(station_of(1), plan(1.0, "", kTwoGroups)); }),
              HasSubstr("2 groups of outlets; the station station has only 1 outlet"));
}

TEST(Stations, PhysicalOneIsRefusedForARun) {
  EXPECT_THAT(refusal_of([] { (void)load_station("serial").make_station(plan(1.0), {}); }),
              AllOf(HasSubstr("serial.toml: "), HasSubstr("gsbench monitor")));
}

TEST_F(StationFiles, OfASourceMakeAStationWithoutOpeningAPort) {
  const auto file = load(kPhysical + kSource +
                         "[relay]\nkind = \"modem\"\n[[outlet]]\nplace = \"a\"\n"
                         "link = \"/dev/gsbench-nowhere-0\"\n[[outlet]]\nplace = \"b\"\n"
                         "relay = \"/dev/gsbench-nowhere-1 DSR\"\n");
  EXPECT_EQ(file.outlets, 2U);
  EXPECT_EQ(file.source_port, "tcp://127.0.0.1:1");
  const auto station = file.make_station(plan(1.0), {});
  const std::vector<Slot> slots = station->slots();
  ASSERT_EQ(slots.size(), 2U);
  EXPECT_EQ(slots[0].place, "a");
  EXPECT_EQ(slots[0].link_id, "/dev/gsbench-nowhere-0");
  EXPECT_FALSE(slots[0].relay_channel);
  EXPECT_FALSE(slots[1].link_id);
  EXPECT_EQ(slots[1].relay_channel, 0U);
  EXPECT_EQ(slots[1].relay_name, "/dev/gsbench-nowhere-1 DSR");
  EXPECT_EQ(station->answers_within(), std::chrono::seconds(12));
  EXPECT_FALSE(station->outlets_count_ticks());
  EXPECT_THAT(station->source_accuracy(), HasSubstr("not calibrated"));
  EXPECT_THAT(station->ports(),
              ElementsAre("tcp://127.0.0.1:1", "/dev/gsbench-nowhere-1", "/dev/gsbench-nowhere-0"));
  EXPECT_FALSE(station->relay_sense().open().ok());
}

TEST(Stations, SimulatedOneCountsTheSourceTicks) {
  EXPECT_TRUE(load_station("simulated").make_station(plan(1.0), {})->outlets_count_ticks());
}

}  // namespace
}  // namespace gsbench::station
