// Physical stations: the instrument, channels of relay senses, and what is refused with its line.
#include "plans.hpp"
#include <test_support/refusal.hpp>
#include <test_support/temporary_folder.hpp>

#include <filesystem>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <station/dry_run.hpp>
#include <station/station_file.hpp>

namespace gsbench::station::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;
using testing::UnorderedElementsAre;

class PhysicalFile : public testing::Test {
 protected:
  StationFile load(const std::string& text) const {
    return load_station(folder_.write("hardware.toml", text));
  }
  std::string refusal_of(const std::string& text) const {
    return gsbench::test::refusal_of<profile::ConfigurationError>([&] { (void)load(text); });
  }

  const gsbench::test::TemporaryFolder folder_;
};

// Nine lines.
constexpr const char* kSourceOfSlots =
    "title = \"A station\"\nkind = \"physical\"\n"
    "[source]\nkind = \"scpi\"\nport = \"tcp://127.0.0.1:1\"\ninstrument = \"siglent-sdg2000x\"\n"
    "gain = 100.0\nvoltage_limit_v = 265.0\nboot_s = 12.0\n";

// Two outlets of a station with modem lines.
std::string on_modem_lines(const std::string& first, const std::string& second) {
  return std::string(kSourceOfSlots) +
         "[relay]\nkind = \"modem\"\n[[outlet]]\nplace = \"a\"\nrelay = \"" + first +
         "\"\n[[outlet]]\nplace = \"b\"\nrelay = \"" + second + "\"\n";
}

TEST_F(PhysicalFile, RefusesAModemLineThatIsNotAPortAndALine) {
  for (const char* channel :
       {"/dev/ttyUSB0 RTS", "/dev/ttyUSB0 DTR", "/dev/ttyUSB0 RI", "/dev/ttyUSB0 cts",
        "/dev/ttyUSB0 CTSX", "/dev/ttyUSB0", "/dev/ttyUSB0 ", "CTS", " CTS", "ttyUSB0 CTS",
        "tcp://127.0.0.1:1 CTS", "/dev/ttyUSB0CTS", "/dev/ttyUSB0  CTS", "/dev/ttyUSB0 CTS ",
        " /dev/ttyUSB0 CTS", "/dev/ttyUSB0\\tCTS", "/dev/ttyUSB0 DSR CTS", "0"}) {
    const std::string text = on_modem_lines("/dev/ttyUSB9 DCD", channel);
    EXPECT_THAT(refusal_of(text),
                AllOf(StartsWith(folder_.file("hardware.toml") + ":17:9: relay is \""),
                      HasSubstr("the path of a serial port, one space, and its line CTS, DSR or "
                                "DCD, such as \"/dev/ttyUSB0 CTS\"")))
        << channel;
  }
}

TEST_F(PhysicalFile, RefusesAModemLineThatIsUsedTwiceUnderAnyNameOfItsPort) {
  const std::string device = folder_.write("ttyUSB0", "");
  const std::string by_id = folder_.file("by-id");
  std::filesystem::create_symlink(device, by_id);
  const auto refusal = [&](const std::string& first, const std::string& second) {
    return refusal_of(on_modem_lines(first, second));
  };
  const std::string at = folder_.file("hardware.toml") + ":17:9: ";
  EXPECT_EQ(refusal(device + " CTS", device + " CTS"),
            at + "relay is \"" + device + " CTS\" for two outlets; it must be unique");
  EXPECT_EQ(refusal(device + " CTS", by_id + " CTS"),
            at + "relay is \"" + device + " CTS\" and \"" + by_id +
                " CTS\" for two outlets, which are the same; it must be unique");
  EXPECT_EQ(refusal(device + " CTS", by_id + " DSR"), "") << "two lines of one port";
  EXPECT_EQ(refusal(device + " CTS", device + "1 CTS"), "") << "two ports";
}

TEST_F(PhysicalFile, GivesEachModemLineItsPort) {
  const auto station =
      load(on_modem_lines("/dev/nowhere-0 CTS", "/dev/nowhere-1 DCD")).make_station(plan(1.0), {});
  EXPECT_THAT(station->ports(),
              ElementsAre("tcp://127.0.0.1:1", "/dev/nowhere-0", "/dev/nowhere-1"));
  ASSERT_EQ(station->slots().size(), 2U);
  EXPECT_EQ(station->slots()[0].relay_channel, 0U);
  EXPECT_EQ(station->slots()[1].relay_channel, 1U);
}

TEST_F(PhysicalFile, RequiresTheSerialNumbersThatItStates) {
  const auto station = load(std::string(kSourceOfSlots) +
                            "[[outlet]]\nplace = \"a\"\nlink = \"/dev/nowhere-0\"\n"
                            "[[outlet]]\nplace = \"b\"\nlink = \"/dev/nowhere-1\"\n"
                            "serial_number = \"GS-7\"\n")
                           .make_station(plan(1.0), {});
  ASSERT_EQ(station->slots().size(), 2U);
  EXPECT_FALSE(station->slots()[0].requires_serial_number);
  EXPECT_EQ(station->slots()[0].serial_number, "a");
  EXPECT_TRUE(station->slots()[1].requires_serial_number);
  EXPECT_EQ(station->slots()[1].serial_number, "GS-7");
}

TEST_F(PhysicalFile, NeedsAPasswordOnlyForItsLink) {
  const auto station =
      load(std::string(kSourceOfSlots) +
           "[mqtt]\nurl = \"mqtt://127.0.0.1:1\"\nuser = \"bench\"\npassword_file = \"pw\"\n"
           "[[outlet]]\nplace = \"a\"\nserial_number = \"GS-7\"\nlink = \"mqtt\"\n")
          .make_station(plan(1.0), {});
  const auto refusal = [&] {
    return gsbench::test::refusal_of<profile::ConfigurationError>([&] { (void)station->link(); });
  };
  const auto refused = [&](const std::string& why) {
    return AllOf(HasSubstr("hardware.toml:"),
                 HasSubstr(": password_file is \"" + folder_.file("pw") + "\", " + why));
  };
  EXPECT_THAT(refusal(), refused("which cannot be read: No such file or directory"));
  for (const std::string empty : {"", "\n", "\r\nsecret\r\n", "\xEF\xBB\xBF\n"}) {
    (void)folder_.write("pw", empty);
    EXPECT_THAT(refusal(), refused("whose first line is empty"));
  }
  (void)folder_.write("pw", std::string("\xFF\xFEs\0e\0", 6));
  EXPECT_THAT(refusal(), refused("which has a NUL in its first line"));
  (void)folder_.write("pw", std::string(65536, 'x') + "\n");
  EXPECT_THAT(refusal(), refused("whose first line has 65536 bytes; a password has at most 65535"));
  (void)folder_.write("pw", "secret\n");
  EXPECT_EQ(refusal(), "");
}

TEST_F(PhysicalFile, NamesThePlaceOfACaFileThatCannotBeUsed) {
  const auto refusal = [&] {
    const auto outlets = *load(
                              "title = \"A\"\nkind = \"physical\"\n[mqtt]\n"
                              "url = \"mqtts://127.0.0.1:1\"\nca_file = \"ca\"\n")
                              .reachable;
    return gsbench::test::refusal_of<profile::ConfigurationError>(
        [&] { (void)make_link(outlets); });
  };
  const auto refused = [&](const std::string& why) {
    return folder_.file("hardware.toml") + ":5:11: ca_file is \"" + folder_.file("ca") +
           "\", from which no CA certificate can be read: " + why;
  };
  EXPECT_EQ(refusal(), refused("No such file or directory"));
  std::filesystem::create_directory(folder_.file("ca"));
  EXPECT_EQ(refusal(), refused("Is a directory"));
  std::filesystem::remove(folder_.file("ca"));
  (void)folder_.write("ca", "");
  EXPECT_EQ(refusal(), refused("it is empty"));
  (void)folder_.write("ca", "no certificate\n");
  EXPECT_EQ(refusal(), refused("no certificate or crl found"));
}

TEST_F(PhysicalFile, LocksAllThatOnlyOneBenchMayUse) {
  const StationFile file = load(
      std::string(kSourceOfSlots) +
      "[relay]\nkind = \"modem\"\n[mqtt]\nurl = \"mqtt://127.0.0.1:1883\"\n"
      "[[outlet]]\nplace = \"a\"\nserial_number = \"GS-7\"\nlink = \"mqtt\"\n"
      "[[outlet]]\nplace = \"b\"\nlink = \"tcp://127.0.0.1:2\"\nrelay = \"/dev/ttyUSB9 CTS\"\n");
  EXPECT_THAT(file.make_station(plan(0.5), {})->ports(),
              UnorderedElementsAre("tcp://127.0.0.1:1", "/dev/ttyUSB9", "tcp://127.0.0.1:2",
                                   "mqtt://127.0.0.1:1883/GS-7"));
}

TEST_F(PhysicalFile, RefusesWhatCannotBeAPort) {
  const std::string head = "title = \"A station\"\nkind = \"physical\"\n";
  const std::string more =
      "\ninstrument = \"siglent-sdg2000x\"\ngain = 100.0\nvoltage_limit_v = 265.0\n[[outlet]]\n"
      "place = \"a\"\nlink = \"";
  for (const std::string wrong :
       {"tcp://:5025", "tcp://10.0.0.5:99999", "tcp://10.0.0.5:0", "tcp://10.0.0.5",
        "tcp://a b:5025", "tcp://a/b:5025", "http://10.0.0.5:5025", "gopher://x",
        "TCPIP::10.0.0.5::5025::SOCKET", "ttyUSB0", "dev/ttyUSB0", "/", "/dev/"}) {
    const auto refused_at = [&](const char* place, const char* key) {
      return AllOf(StartsWith(fmt::format("{}:{}: {} is \"{}\"", folder_.file("hardware.toml"),
                                          place, key, wrong)),
                   HasSubstr("tcp://host:port, with a port from 1 to 65535, or the path of"));
    };
    EXPECT_THAT(
        refusal_of(fmt::format("{}[source]\nkind = \"scpi\"\nport = \"{}\"{}/dev/ttyUSB0\"\n", head,
                               wrong, more)),
        refused_at("5:8", "port"));
    EXPECT_THAT(
        refusal_of(fmt::format("{}[source]\nkind = \"scpi\"\nport = \"/dev/ttyACM0\"{}{}\"\n", head,
                               more, wrong)),
        refused_at("11:8", "link"));
    EXPECT_THAT(
        refusal_of(fmt::format("{}[serial]\nports = [\"/dev/ttyUSB0\", \"{}\"]\n", head, wrong)),
        refused_at("4:26", "ports"));
  }
}

TEST_F(PhysicalFile, RefusesAnOutletOnThePortOfTheSource) {
  const std::string text = std::string(kSourceOfSlots) + "[[outlet]]\nplace = \"a\"\nlink = \"";
  EXPECT_THAT(refusal_of(text + "tcp://127.0.0.1:1\"\n"),
              AllOf(StartsWith(folder_.file("hardware.toml") + ":12:8: link is "),
                    HasSubstr("the port of the source")));
  EXPECT_EQ(refusal_of(text + "tcp://127.0.0.1:2\"\n"), "");
}

TEST_F(PhysicalFile, RefusesABaudRateThatNoPortHas) {
  const std::string serial =
      "title = \"A station\"\nkind = \"physical\"\n[serial]\nports = [\"/dev/ttyUSB0\"]\n";
  EXPECT_THAT(refusal_of(serial + "baud = 12345\n"),
              AllOf(StartsWith(folder_.file("hardware.toml") + ":5:8: baud is 12345"),
                    HasSubstr(" 9600, ")));
  EXPECT_EQ(refusal_of(serial + "baud = 460800\n"), "");
  const std::string slot = "[[outlet]]\nplace = \"a\"\nlink = \"/dev/ttyUSB0\"\n";
  EXPECT_THAT(refusal_of(kSourceOfSlots + ("baud = 115201\n" + slot)),
              StartsWith(folder_.file("hardware.toml") + ":10:8: baud is 115201"));
  EXPECT_EQ(refusal_of(kSourceOfSlots + ("baud = 9600\n" + slot)), "");
}

TEST_F(PhysicalFile, RefusesAHeadThatCannotPlayNominalVoltage) {
  const auto head = [](const std::string& gain, const std::string& full_scale_v) {
    return "title = \"A station\"\nkind = \"physical\"\n[source]\nkind = \"head\"\n"
           "port = \"/dev/ttyACM0\"\ngain = " +
           gain + "\nvoltage_limit_v = 265.0\ndac_full_scale_v = " + full_scale_v +
           "\n[[outlet]]\nplace = \"a\"\nlink = \"/dev/ttyUSB0\"\n";
  };
  for (const std::string& text : {head("1.0", "1.5"), head("240.0", "1e-9")}) {
    EXPECT_THAT(refusal_of(text), AllOf(StartsWith(folder_.file("hardware.toml") + ":6:8: "),
                                        HasSubstr("nominal voltage, 325.3 V peak, is beyond")));
  }
  EXPECT_EQ(refusal_of(head("240.0", "1.5")), "");
}

// The table of bench/station/README.md, with boot_s = 12.
TEST_F(PhysicalFile, PlaysRunsAsLongAsTheGuideStates) {
  const auto refusal = [&](const std::string& instrument, double signal_s,
                           const std::string& boot = "boot_s = 12.0") {
    std::string text = std::string(kSourceOfSlots) +
                       "[[outlet]]\nplace = \"a\"\nlink = \"/dev/nowhere-0\"\n"
                       "[[outlet]]\nplace = \"b\"\nlink = \"/dev/nowhere-1\"\n";
    const std::string shipped = "siglent-sdg2000x";
    text.replace(text.find(shipped), shipped.size(), instrument);
    text.replace(text.find("boot_s = 12.0"), 13, boot);
    const profile::Plan longest = plan(signal_s);
    const auto station = load(text).make_station(longest, {});
    return gsbench::test::refusal_of<profile::ConfigurationError>(
        [&] { (void)dry_run(longest, *station); });
  };
  EXPECT_EQ(refusal("keysight-33500b", 34.0 - 12.0), "");
  EXPECT_THAT(refusal("keysight-33500b", 35.0 - 12.0), HasSubstr("voltage by 2.04 %"));
  EXPECT_EQ(refusal("rigol-dg1000z", 76.0 - 12.0), "");
  EXPECT_THAT(refusal("rigol-dg1000z", 77.0 - 12.0), HasSubstr("voltage by 2.04 %"));
  EXPECT_EQ(refusal("siglent-sdg2000x", 60.0), "");
  EXPECT_THAT(refusal("siglent-sdg1000x", 6.0, "boot_s = 0.0"),
              HasSubstr("the voltage would deviate by up to 12.5"));
}

TEST_F(PhysicalFile, RefusesAnInstrumentThatIsUnknown) {
  const auto refusal = [&](const std::string& instrument) {
    std::string text = on_modem_lines("/dev/nowhere-0 CTS", "/dev/nowhere-1 CTS");
    const std::string shipped = "siglent-sdg2000x";
    return refusal_of(text.replace(text.find(shipped), shipped.size(), instrument));
  };
  const std::string at = folder_.file("hardware.toml") + ":6:14: ";
  EXPECT_THAT(refusal("siglent-sdg200x"),
              AllOf(StartsWith(at + "unknown instrument \"siglent-sdg200x\""),
                    HasSubstr("\"siglent-sdg2000x\"")));
  EXPECT_EQ(refusal("mine.toml"),
            at + "instrument is \"mine.toml\", which is not an existing file");
  // An error in the instrument's file has its own place.
  const std::string mine = folder_.write("mine.toml", "title = 3\n");
  EXPECT_THAT(refusal("mine.toml"), StartsWith(mine + ":1:"));
}

}  // namespace
}  // namespace gsbench::station::test
