// gs-outlet without the bench, as another team starts it to test a control centre.
#include <firmware_test/settings.hpp>
#include <link_framed/framed_link.hpp>
#include <link_test/bench_options.hpp>
#include <link_test/link_fixture.hpp>
#include <pty.hpp>
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>
#include <wire_test/messages.hpp>

#include <cmath>
#include <fstream>
#include <optional>

#include <gmock/gmock.h>

#include <emulation/child.hpp>
#include <emulation/listening.hpp>

namespace gsbench::test {
namespace {

using emulation::Child;
using gs::outlet::Validity;
using gs::wire::UplinkKind;

constexpr const char* kKitchen = "kitchen-1";

class GsOutletAlone : public LinkFixture {
 protected:
  void start(std::vector<std::string> arguments, const std::string& id = kKitchen) {
    arguments.insert(arguments.begin(), GS_OUTLET_PROGRAM);
    arguments.insert(arguments.end(), {"--id", id});
    outlet_.emplace(demand(Child::start({arguments, ""})));
  }
  // Starts it on a TCP port and opens a link to it.
  void start_and_open(std::vector<std::string> arguments) {
    const std::string address = "127.0.0.1:" + std::to_string(port_.number());
    arguments.insert(arguments.end(), {"--listen", address});
    start(arguments);
    open(std::make_shared<link::FramedLink>(link::FramedOptions{{"tcp://" + address}}), {kKitchen},
         std::chrono::seconds(20));
    ASSERT_EQ(present(kKitchen).fault, "");
  }
  // Waits for a valid frequency near this one.
  bool measures(float frequency_hz) {
    return until([&] {
      const auto measured = messages(kKitchen, UplinkKind::kMeasurement);
      return !measured.empty() &&
             measured.back().message.measurement.validity == Validity::kValid &&
             std::fabs(measured.back().message.measurement.frequency_hz - frequency_hz) < 0.01F;
    });
  }
  gs::wire::SettingsAnswer send_settings(std::uint32_t version) {
    gs::outlet::Settings settings = gs::test::ieee24_settings();
    settings.version = version;
    send(kKitchen, gs::wire::test::settings_message(settings));
    EXPECT_TRUE(arrives(kKitchen, UplinkKind::kSettingsAnswer));
    return messages(kKitchen, UplinkKind::kSettingsAnswer).back().message.settings_answer;
  }

  TemporaryFolder folder_;
  emulation::LoopbackPort port_ = demand(emulation::LoopbackPort::reserve());
  std::optional<Child> outlet_;
};

TEST_F(GsOutletAlone, MeasuresSteadyMainsAndDoesNotClaimToKeepSettings) {
  start_and_open({"--instance", "4711", "--nominal", "60"});
  EXPECT_EQ(present(kKitchen).hello.instance, 4711U);
  EXPECT_EQ(present(kKitchen).hello.nominal_hz, 60);
  EXPECT_EQ(present(kKitchen).hello.capabilities, 0U);
  EXPECT_TRUE(measures(60.0F));
  send(kKitchen, command(false));
  EXPECT_TRUE(arrives(kKitchen, UplinkKind::kRelay));
}

TEST_F(GsOutletAlone, KeepsSettingsInItsFlashFile) {
  const std::string flash = folder_.file("kitchen-1.flash");
  start_and_open({"--flash", flash});
  EXPECT_TRUE(send_settings(7).kept);
  link_.reset();
  outlet_.reset();
  messages_.clear();
  port_ = demand(emulation::LoopbackPort::reserve());
  start_and_open({"--flash", flash});
  EXPECT_EQ(present(kKitchen).hello.settings_version, 7U);
  link_.reset();
  outlet_.reset();
  port_ = demand(emulation::LoopbackPort::reserve());
  start_and_open({});
  EXPECT_EQ(present(kKitchen).hello.settings_version, 0U);
  EXPECT_FALSE(send_settings(8).kept);
}

TEST_F(GsOutletAlone, PlaysALoss) {
  start_and_open({"--loss", "500", "--loss-at", "1"});
  ASSERT_TRUE(measures(50.0F));
  EXPECT_TRUE(until([&] {
    const auto measured = messages(kKitchen, UplinkKind::kMeasurement);
    return measured.back().message.measurement.frequency_hz < 49.35F;
  }));
}

TEST_F(GsOutletAlone, PlaysAFileOfFrequencies) {
  start_and_open({"--signal", folder_.write("f.csv",
                                            "\xEF\xBB\xBFt_s, frequency_hz,note\r\n"
                                            "100,50,a\r\n101.5,50,b\r\n+102,49.5,c\r\n")});
  EXPECT_TRUE(measures(50.0F));
  EXPECT_TRUE(measures(49.5F)) << "the last frequency stays";
}

TEST_F(GsOutletAlone, PlaysAFileOfVoltages) {
  const std::string path = folder_.file("v.csv");
  std::ofstream file(path);
  file << "t_s,frequency_hz,rocof_hz_s,voltage_pu\n";
  for (int i = 0; i < 24000; ++i) {
    file << i / 8000.0 << ",50,0," << std::cos(2.0 * 3.14159265358979 * 50.2 * i / 8000.0) << '\n';
  }
  file.close();
  start_and_open({"--signal", path});
  EXPECT_TRUE(measures(50.2F));
  EXPECT_TRUE(until([&] {
    const auto measured = messages(kKitchen, UplinkKind::kMeasurement);
    return measured.back().message.measurement.voltage_pu < 0.01F;
  })) << "the voltage is 0 after the end";
}

TEST_F(GsOutletAlone, SpeaksOnASerialPort) {
  const Pty port(folder_.file("port"));
  start({"--serial", folder_.file("port")});
  gs::wire::FrameReader reader;
  std::vector<gs::wire::test::Bytes> found;
  ASSERT_TRUE(test::until([&] {
    std::uint8_t bytes[256];
    const ssize_t got = ::read(port.master(), bytes, sizeof bytes);
    if (got > 0) {
      for (auto& frame : gs::wire::test::frames_in(reader, {bytes, bytes + got})) {
        found.push_back(std::move(frame));
      }
    }
    return !found.empty();
  }));
  gs::wire::Uplink message;
  std::uint32_t sequence = 99;
  ASSERT_EQ(gs::wire::decode(found[0].data(), found[0].size(), message, sequence),
            gs::wire::Decoded::kOk);
  EXPECT_STREQ(message.hello.id, kKitchen);
  EXPECT_EQ(sequence, 0U);
}

TEST_F(GsOutletAlone, JoinsABrokerAndDepartsFromIt) {
  const auto broker = demand(emulation::PrivateBroker::start({folder_.file("broker"), {kKitchen}}));
  const std::string password = folder_.write("password", broker.outlet(kKitchen).password + "\n");
  start({"--mqtt", broker.url(), "--ca", broker.ca_file(), "--password-file", password});
  open(std::make_shared<link::MqttLink>(bench_options(broker, {kKitchen})), {kKitchen},
       std::chrono::seconds(20));
  EXPECT_TRUE(measures(50.0F));
  outlet_->stop();
  EXPECT_TRUE(is_reported(kKitchen, "left the broker"));
  link_.reset();
}

}  // namespace
}  // namespace gsbench::test
