// Runs on stations of kind "physical", to a verdict: emulated instruments, connected to emulated
// outlets by a wire, and reached as real ones are, by the port in the station file.
#include "gsbench_process.hpp"
#include "pty.hpp"
#include <poll.h>
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>
#include <unistd.h>

#include <array>
#include <atomic>
#include <memory>
#include <sstream>
#include <thread>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <emulation/generator.hpp>
#include <emulation/hardware.hpp>
#include <emulation/head_emulator.hpp>
#include <emulation/wire.hpp>
#include <profile/load.hpp>
#include <render/layout.hpp>
#include <station/run.hpp>
#include <station/station_file.hpp>
#include <station/station_lock.hpp>
#include <transport/transport.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr double kGain = 236.0;

// The frequency falls from 50 Hz at 0.4 s to 48.8 Hz at 0.8 s and is 49.5 Hz at 0.567 s.
constexpr const char* kFall =
    "title = \"A fall\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
    "duration_s = 1.5\nfrequency = [[0.0, 50.0], [0.4, 50.0], [0.8, 48.8], [1.5, 48.8]]\n"
    "[[outlet]]\ncount = 2\nthreshold_mw = 5000.0\nswitch_off_hz = 49.5\n"
    "[[expect]]\nmeasure = \"relay.end\"\nequals = \"open\"\n"
    "[[expect]]\nmeasure = \"trip.time\"\nunit = \"s\"\nmin = 0.56\nmax = 0.9\n"
    "[[expect]]\nmeasure = \"relay.edges\"\nmin = 1\nmax = 1\n";

constexpr const char* kSteady =
    "title = \"Steady\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
    "duration_s = 0.5\n[[outlet]]\n[[expect]]\nmeasure = \"event.count\"\nmax = 0\n";

// A serial cable: a pseudo-terminal at `path` for the bench, and the TCP port of an emulator.
class SerialCable {
 public:
  SerialCable(const std::string& path, const std::string& emulator)
      : pty_(path), far_end_(transport::make_transport(emulator)) {
    demand(far_end_->open());
    thread_ = std::thread([this] { run(); });
  }
  ~SerialCable() {
    ending_ = true;
    thread_.join();
  }
  SerialCable(const SerialCable&) = delete;
  SerialCable& operator=(const SerialCable&) = delete;

 private:
  void run() {
    while (!ending_) {
      std::array<pollfd, 2> ends = {
          pollfd{pty_.master(), POLLIN, 0},
          pollfd{far_end_->descriptor(), POLLIN, 0},
      };
      (void)::poll(ends.data(), ends.size(), 5);
      std::vector<std::uint8_t> bytes(4096);
      const ssize_t count = ::read(pty_.master(), bytes.data(), bytes.size());
      bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0U);
      EXPECT_TRUE(far_end_->send(bytes).ok());
      bytes.clear();
      EXPECT_TRUE(far_end_->receive(bytes, transport::Clock::now()).ok());
      for (std::size_t sent = 0; sent < bytes.size() && !ending_;) {
        const ssize_t some = ::write(pty_.master(), bytes.data() + sent, bytes.size() - sent);
        sent += some > 0 ? static_cast<std::size_t>(some) : 0U;
      }
    }
  }

  Pty pty_;
  std::unique_ptr<transport::Transport> far_end_;
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last: it uses the others
};

class PhysicalRun : public testing::Test {
 protected:
  // An outlet on a serial line, and a frequency relay.
  void SetUp() override {
    emulation::HardwareOptions options;
    options.outlets.resize(2);
    options.outlets[0].id = "outlet-7";
    options.outlets[0].crystal_ppm = 30.0;
    options.outlets[1].id = "relay";
    options.outlets[1].connection = emulation::Connection::kNone;
    options.outlets[1].frequency_relay = {49.5, 0.05};
    options.host_program = GS_OUTLET_PROGRAM;
    hardware_ = demand(emulation::Hardware::set_up(options));
  }
  void TearDown() override {
    wire_.reset();
    for (const std::string& port : ports_) {
      std::filesystem::remove(station::lock_files(port).front());
    }
  }

  void connect(emulation::Output& output, const emulation::WireOptions& more = {}) {
    emulation::WireOptions options = more;
    options.gain = kGain;
    wire_ = std::make_unique<emulation::Wire>(hardware_->outlets(), output, time_, options);
  }

  std::string station(const std::string& source, const std::string& port,
                      const std::string& outlets) {
    ports_ = {port, hardware_->serial_ports().front()};
    return folder_.write("lab.toml", fmt::format("title = \"A lab\"\nkind = \"physical\"\n"
                                                 "[source]\nport = \"{}\"\ngain = {}\n"
                                                 "voltage_limit_v = 240.0\nboot_s = 1.0\n{}{}",
                                                 port, kGain, source, outlets));
  }
  std::string link() const { return hardware_->serial_ports().front(); }

  const TemporaryFolder folder_;
  emulation::TrueTime time_;
  std::unique_ptr<emulation::Hardware> hardware_;
  std::unique_ptr<emulation::Wire> wire_;
  std::vector<std::string> ports_;
};

// In this process, which takes a pseudo-terminal for a serial port.
TEST_F(PhysicalRun, AHeadOnASerialPortTestsAnOutletAndAContactOnlyDevice) {
  emulation::HeadEmulatorOptions options;
  options.clock_ppm = -8.0;
  const auto head = demand(emulation::HeadEmulator::create(options));
  const SerialCable cable(folder_.file("ttyACM0"), head->port());
  head->set_input(1, 0, true);
  head->set_input(3, 0, true);
  emulation::WireOptions contacts;
  contacts.on_edge = [&](std::size_t outlet, std::int64_t step, bool closed) {
    head->set_input(outlet == 0 ? 3 : 1, step, closed);
  };
  connect(*head, contacts);
  const station::StationFile file = station::load_station(
      station("kind = \"head\"\nclock_ppm = 10.0\nopto_close_delay_us = 0.0\n"
              "opto_open_delay_us = 0.0\nopto_uncertainty_us = 0.0\n[relay]\nkind = \"head\"\n",
              folder_.file("ttyACM0"),
              fmt::format("[[outlet]]\nplace = \"a\"\nlink = \"{}\"\nrelay = \"3\"\n"
                          "[[outlet]]\nplace = \"b\"\nrelay = \"1\"\n",
                          link())));
  const profile::Plan plan = profile::parse_profile(kFall, "fall.toml");
  const auto station = file.make_station(plan, {});
  const record::RunRecord record = station::run(plan, *station, {});

  ASSERT_EQ(record.verdict, record::Verdict::kPass) << record.verdict_reason;
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_EQ(record.outlets[0].id, "outlet-7");
  // Three standard deviations: the uncertainty is expanded with k = 2, and in real time the noise
  // differs from run to run.
  EXPECT_NEAR(record.outlets[0].clock.drift_ppm, 38.0,
              1.5 * record.outlets[0].clock.drift_uncertainty_ppm);
  EXPECT_EQ(record.outlets[1].id, "b");
  EXPECT_TRUE(record.outlets[1].reports.trace.tick.empty());
  // 50 ms of delay, 50 to 120 ms of measurement, 6.5 to 9.5 ms of the contact.
  const auto* const relay_trip = record::find_measurement(record.outlets[1], "trip.time");
  ASSERT_NE(relay_trip, nullptr);
  EXPECT_GT(relay_trip->value, 0.567 + 0.1);
  EXPECT_LT(relay_trip->value, 0.567 + 0.2);
  EXPECT_EQ(head->observe().state, gs::head::State::kOff);
  EXPECT_TRUE(file.make_source()->make_safe().ok()) << "also when it is off";
}

TEST_F(PhysicalRun, AGeneratorPlaysToAnOutletAndIsOffAfterwards) {
  const auto generator =
      demand(emulation::Generator::start({emulation::GeneratorModel::kSdg2042x, 1.0, time_}));
  connect(*generator);
  const std::string lab =
      station("kind = \"scpi\"\ninstrument = \"siglent-sdg2000x\"\n", generator->port(),
              fmt::format("[[outlet]]\nplace = \"a\"\nlink = \"{}\"\n", link()));
  const std::string profile = folder_.write("steady.toml", kSteady);
  const Outcome outcome =
      run_gsbench({"run", profile, "--station", lab, "--out", folder_.file("runs")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("outlet-7"),
                                 HasSubstr("\nSource: Siglent SDG2000X at " + generator->port() +
                                           ": 265921 points at 32000 Sa/s, played once\nAt most "),
                                 Not(HasSubstr("soft rise"))));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_TRUE(render::columns_of(line) <= render::kLineColumns || line.rfind("Report: ", 0) == 0)
        << line;
  }
  EXPECT_FALSE(generator->output_is_on());
  emulation::PanelChange on;
  on.output_on = true;
  generator->press(on);
  EXPECT_EQ(run_gsbench({"safe", lab}).exit_code, 0);
  EXPECT_FALSE(generator->output_is_on());
}

TEST_F(PhysicalRun, AGeneratorThatAnswersAfterAFifthOfASecondPlaysToAVerdict) {
  const auto generator =
      demand(emulation::Generator::start({emulation::GeneratorModel::kSdg2042x, 1.0, time_}));
  connect(*generator);
  emulation::GeneratorFaults faults;
  faults.answer_delay_s = 0.2;
  generator->set_faults(faults);
  const profile::Plan plan = profile::parse_profile(kSteady, "steady.toml");
  const auto lab =
      station::load_station(
          station("kind = \"scpi\"\ninstrument = \"siglent-sdg2000x\"\n", generator->port(),
                  fmt::format("[[outlet]]\nplace = \"a\"\nlink = \"{}\"\n", link())))
          .make_station(plan, {});
  const record::RunRecord record = station::run(plan, *lab, {});
  EXPECT_EQ(record.verdict, record::Verdict::kPass) << record.verdict_reason;
  EXPECT_FALSE(generator->output_is_on());
}

TEST_F(PhysicalRun, AnOutletThatCannotBeReachedIsAtFaultAndTheOtherOneIsTested) {
  const auto generator =
      demand(emulation::Generator::start({emulation::GeneratorModel::kSdg2042x, 1.0, time_}));
  connect(*generator);
  const std::string nobody = "tcp://127.0.0.1:1";
  const auto lab = [&](const std::string& first) {
    return station("kind = \"scpi\"\ninstrument = \"siglent-sdg2000x\"\n", generator->port(),
                   fmt::format("[[outlet]]\nplace = \"a\"\nlink = \"{}\"\n"
                               "[[outlet]]\nplace = \"b\"\nlink = \"{}\"\n",
                               first, nobody));
  };
  std::string two = kSteady;
  two.replace(two.find("[[outlet]]"), 10, "[[outlet]]\ncount = 2");
  const profile::Plan plan = profile::parse_profile(two, "steady.toml");
  const auto of_two = station::load_station(lab(link())).make_station(plan, {});
  const record::RunRecord record = station::run(plan, *of_two, {});
  ASSERT_EQ(record.outlets.size(), 2U) << record.fault;
  EXPECT_EQ(record.outlets[0].id, "outlet-7");
  EXPECT_EQ(record.outlets[0].verdict, record::Verdict::kPass) << record.outlets[0].fault;
  EXPECT_EQ(record.outlets[1].verdict, record::Verdict::kError);
  EXPECT_THAT(record.outlets[1].fault, HasSubstr("cannot be connected to: "));

  generator->clear_messages();
  const auto of_none = station::load_station(lab("tcp://localhost:1")).make_station(plan, {});
  EXPECT_THAT(station::run(plan, *of_none, {}).fault, HasSubstr("no outlet is left"));
  EXPECT_THAT(generator->messages(), Not(testing::Contains("C1:OUTP ON")));
  ports_.insert(ports_.end(), {link(), nobody, "tcp://localhost:1"});  // their lock files
}

}  // namespace
}  // namespace gsbench::test
