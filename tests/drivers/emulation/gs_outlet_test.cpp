// The command line of gs-outlet: messages for bad usage, and exit codes.
#include "shared_memory_file.hpp"
#include <test_support/demand.hpp>
#include <test_support/output_of.hpp>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <filesystem>
#include <optional>

#include <gmock/gmock.h>

#include <emulation/child.hpp>
#include <emulation/null_modem.hpp>

namespace gsbench::test {
namespace {

using emulation::Child;
using emulation::NullModem;
using emulation::SharedMemoryFile;
using testing::HasSubstr;
using testing::StartsWith;

// Returns standard output and standard error together.
Output run(const std::string& arguments) {
  return output_of(std::string(GS_OUTLET_PROGRAM) + " " + arguments + " 2>&1");
}

class GsOutlet : public testing::Test {
 protected:
  // Bad usage: exit code 2, the reason in one line, and a hint at --help.
  static void expect_refused(const std::string& arguments, const std::string& why) {
    const Output output = run(arguments);
    EXPECT_EQ(output.exit_code, 2) << arguments;
    EXPECT_THAT(output.text, StartsWith("gs-outlet: " + why)) << arguments;
    EXPECT_THAT(output.text, testing::EndsWith("; see `gs-outlet --help`\n")) << arguments;
  }

  std::string at_terminals() const {
    return " --terminals " + file_->path() + " --doorbell " + file_->doorbell();
  }

  std::string line_address() const { return "127.0.0.1:" + std::to_string(cable_->outlet_end()); }
  std::string line() const { return "--tcp " + line_address(); }

  TemporaryFolder folder_;
  std::optional<SharedMemoryFile> file_ =
      demand(SharedMemoryFile::create(folder_.path().string(), {"a", 0, 8000, 50, 20000.0F}));
  std::unique_ptr<NullModem> cable_ = demand(NullModem::create());
};

TEST_F(GsOutlet, PrintsHelp) {
  const Output output = run("--help");
  EXPECT_EQ(output.exit_code, 0);
  for (const char* option :
       {"--tcp", "--mqtt", "--ca", "--user", "--password-file", "--terminals", "--doorbell",
        "--serial", "--listen", "--id", "--signal", "--loss", "--flash", "Examples:"}) {
    EXPECT_THAT(output.text, HasSubstr(option));
  }
}

TEST_F(GsOutlet, PrintsHelpWhereverItIsAskedFor) {
  const std::string help = run("--help").text;
  for (const char* arguments :
       {"-h", "--id a --help", "--listen 127.0.0.1:1 -h", "--wrong --help"}) {
    const Output output = run(arguments);
    EXPECT_EQ(output.exit_code, 0) << arguments;
    EXPECT_EQ(output.text, help) << arguments;
  }
}

TEST_F(GsOutlet, PrintsTheVersionAndTheBuildThatItsHelloHas) {
  const Output output = run("--version");
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_THAT(output.text,
              testing::MatchesRegex("gs-outlet 0\\.1\\.0, build [0-9a-f]{8}, protocol 3\n"));
}

TEST_F(GsOutlet, RefusesUnknownArguments) {
  for (const std::string wrong : {"--nonsense", "--tcp", "--mqtt mqtt://a:1 something"}) {
    const Output output = run(wrong);
    EXPECT_EQ(output.exit_code, 2) << wrong;
    EXPECT_THAT(output.text,
                testing::EndsWith("gs-outlet: invalid arguments; see `gs-outlet --help`\n"));
  }
}

TEST_F(GsOutlet, RequiresExactlyOneConnection) {
  expect_refused(at_terminals(), "exactly one of --serial, --listen, --tcp and --mqtt is required");
  expect_refused("--tcp 127.0.0.1:1 --mqtt mqtt://127.0.0.1:1" + at_terminals(),
                 "exactly one of --serial, --listen, --tcp and --mqtt is required");
}

TEST_F(GsOutlet, RefusesInvalidConnections) {
  cable_->unplug();
  expect_refused(line() + at_terminals(), line_address() + ": Connection refused");
  for (const std::string wrong : {"127.0.0.1", "127.0.0.1:", "127.0.0.1:70000", "::1:5000"}) {
    expect_refused("--tcp " + wrong + at_terminals(), "\"" + wrong + "\" is not ADDRESS:PORT");
  }
  expect_refused("--mqtt 127.0.0.1" + at_terminals(), "\"127.0.0.1\" is not mqtts://host:port");
  expect_refused("--mqtt mqtts://127.0.0.1:1 --ca /nowhere/ca" + at_terminals(),
                 "the CA file \"/nowhere/ca\" cannot be read");
  expect_refused("--mqtt mqtts://127.0.0.1:1 --ca / --id a",
                 "the CA file \"/\" cannot be read (--ca): Is a directory");
  expect_refused("--mqtt mqtts://127.0.0.1:1 --id a", "mqtts:// needs --ca FILE");
  expect_refused("--tcp no-such-host.invalid:1 --id a",
                 "no-such-host.invalid:1: cannot be found: ");
  expect_refused("--mqtt mqtt://127.0.0.1:1 --password-file /nowhere/password" + at_terminals(),
                 "/nowhere/password: cannot be read");
}

TEST_F(GsOutlet, RefusesInvalidTerminalFiles) {
  expect_refused(line() + " --terminals /nowhere/file --doorbell " + file_->doorbell(),
                 "/nowhere/file: No such file or directory");
  const std::string other = folder_.write("other", "something else");
  expect_refused(line() + " --terminals " + other + " --doorbell " + file_->doorbell(),
                 other + ": not a terminals file");
  const std::string unmade =
      folder_.write("unmade", std::string(sizeof(gs::shared_memory_io::SharedMemory), '\0'));
  expect_refused(line() + " --terminals " + unmade + " --doorbell " + file_->doorbell(),
                 unmade + ": not a terminals file");
}

TEST_F(GsOutlet, RefusesInvalidDoorbells) {
  const std::string start = line() + " --terminals " + file_->path();
  expect_refused(start + " --doorbell /nowhere/bell", "/nowhere/bell: No such file or directory");
  expect_refused(start + " --doorbell /" + std::string(200, 'x'),
                 "/" + std::string(200, 'x') + ": too long for a socket");
}

TEST_F(GsOutlet, RefusesUnsupportedSampleRates) {
  file_->terminals().sample_rate_hz = 100;
  expect_refused(line() + at_terminals(),
                 "the firmware does not support the hardware in the terminals file: 100 Hz sample "
                 "rate, 50 Hz nominal");
}

TEST_F(GsOutlet, RefusesWhatDoesNotFitWithoutTheBench) {
  const std::string alone = "--listen 127.0.0.1:1 ";
  expect_refused(alone, "--id is required without --terminals");
  const std::string too_long(33, 'x');
  for (const char* wrong : {"'$x'", "''", "a/b", too_long.c_str()}) {
    std::string arguments = alone;
    arguments.append("--id ").append(wrong);
    EXPECT_EQ(run(arguments).exit_code, 2) << wrong;
  }
  const std::string named = alone + "--id a ";
  expect_refused(named + "--doorbell bell", "--doorbell needs --terminals");
  expect_refused(named + "--nominal 55", "--nominal must be 50 or 60");
  expect_refused(named + "--nominal 49", "--nominal is \"49\"; it must be a number from 50 to 60");
  expect_refused(named + "--sample-rate 8500", "--sample-rate must be a multiple of 1000");
  expect_refused(named + "--loss lots",
                 "--loss is \"lots\"; it must be a number from -2000 to 2000; see");
  expect_refused(named + "--loss-at 3", "--loss-at needs --loss");
  expect_refused(named + "--loss 3 --signal f", "give --signal or --loss, not both");
  const std::string other = folder_.write("other", "something else");
  expect_refused(line() + " --id a --flash " + other, other + ": not the flash of an outlet");
  expect_refused(line() + " --id a --flash /dev/null", "/dev/null: is no ordinary file");
  expect_refused("--serial /nowhere/tty --id a", "/nowhere/tty: No such file or directory");
  expect_refused("--serial " + other + " --id a", other + ": is not a serial port");
}

TEST_F(GsOutlet, RefusesOptionsThatHaveNoEffect) {
  const auto expect = [](const std::string& arguments, const std::string& option,
                         const std::string& value, const std::string& why) {
    expect_refused(arguments + " --" + option + ' ' + value, "--" + option + why);
  };
  for (const char* const option : {"ca", "user", "password-file"}) {
    expect("--listen 127.0.0.1:1 --id a", option, "x", " has no effect without --mqtt");
  }
  expect("--mqtt MQTT://127.0.0.1:1 --id a", "ca", "x", " has no effect with mqtt://");
  for (const char* const option :
       {"id", "instance", "nominal", "sample-rate", "signal", "loss", "loss-at", "flash"}) {
    expect(line() + at_terminals(), option, "50", " has no effect with --terminals, which has ");
  }
  for (const char* const option : {"tcp", "mqtt", "id", "loss", "flash", "ca", "terminals"}) {
    expect("--listen 127.0.0.1:1", option, "''", " is empty");
  }
  expect("--listen 127.0.0.1:1 --id a", "id", "b", " is given twice");
  expect_refused(line() + " --terminals " + file_->path(), "--terminals needs --doorbell");
}

TEST_F(GsOutlet, HasItsFlashFileAlone) {
  const std::string flash = folder_.file("flash");
  cable_->unplug();
  expect_refused(line() + " --id a --flash " + flash, line_address() + ": Connection refused");
  EXPECT_FALSE(std::filesystem::exists(flash)) << "a refused command makes no file";
  ASSERT_TRUE(cable_->plug_in().ok());
  Child first = demand(Child::start(
      {{GS_OUTLET_PROGRAM, "--mqtt", "mqtt://127.0.0.1:1", "--id", "a", "--flash", flash}, ""}));
  ASSERT_TRUE(until([&] { return std::filesystem::exists(flash); }));
  const std::string second = line() + " --id b --flash " + flash;
  expect_refused(second, flash + ": is used by another process");
  first.stop();
  EXPECT_EQ(run(second + " & pid=$!; sleep 0.3; kill $pid; wait $pid").exit_code, 0);
}

TEST_F(GsOutlet, RefusesASignalFileWithThePlace) {
  const std::string path = folder_.file("signal.csv");
  const auto expect = [&](const std::string& text, const std::string& why) {
    folder_.write("signal.csv", text);
    expect_refused("--listen 127.0.0.1:1 --id a --signal " + path, path + ":" + why);
  };
  expect("", "1:1: needs a header and at least two rows");
  expect("t_s,frequency_hz\n0,50\n", "2:1: needs a header and at least two rows");
  expect("time,frequency_hz\n0,50\n",
         "1:1: the header must name a column t_s and a column frequency_hz or voltage_pu");
  expect("t_s,frequency_hz\n0,50\n1,fifty\n", "3:3: \"fifty\" is not a number");
  expect("t_s,frequency_hz\n0,50\n1\n", "3:1: the row has too few cells");
  expect("t_s,frequency_hz\n0,nan\n", "2:3: \"nan\" is not a number");
  expect("t_s,frequency_hz\n0,50\n0,50\n", "3:1: the time must be later than in the row before");
  expect("t_s,frequency_hz\n0,4\n", "2:3: \"4\" is outside of 25 … 75 Hz");
  expect("t_s,voltage_pu\n0,325\n", "2:3: \"325\" is outside of -1.5 … 1.5 p.u.");
  expect_refused("--listen 127.0.0.1:1 --id a --signal /nowhere/s",
                 "/nowhere/s: cannot be read: No such file or directory");
  expect_refused("--listen 127.0.0.1:1 --id a --signal /", "/: cannot be read: Is a directory");
}

TEST_F(GsOutlet, EndsOnSigterm) {
  const Output output = run(line() + at_terminals() + " & pid=$!; sleep 0.3; kill $pid; wait $pid");
  EXPECT_EQ(output.exit_code, 0) << output.text;
}

TEST_F(GsOutlet, EndsWhenTheBenchEnds) {
  Child outlet = demand(Child::start({{GS_OUTLET_PROGRAM, "--tcp", line_address(), "--terminals",
                                       file_->path(), "--doorbell", file_->doorbell()},
                                      ""}));
  ASSERT_TRUE(until([&] {
    file_->ring();  // accepts its connection
    return file_->terminals().starts == 1;
  }));
  EXPECT_TRUE(outlet.running());
  file_.reset();
  EXPECT_TRUE(until([&] { return !outlet.running(); }));
}

}  // namespace
}  // namespace gsbench::test
