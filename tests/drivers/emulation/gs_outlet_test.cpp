// gs-outlet as its users meet it: what it says of bad usage, and its exit codes.
#include "shared_memory_file.hpp"
#include "waiting.hpp"
#include <sys/wait.h>
#include <test_support/temporary_folder.hpp>

#include <array>
#include <cstdio>
#include <optional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/child.hpp>
#include <emulation/null_modem.hpp>

namespace {

using gsbench::emulation::Child;
using gsbench::emulation::NullModem;
using gsbench::emulation::SharedMemoryFile;
using gsbench::test::TemporaryFolder;
using gsbench::test::until;
using testing::HasSubstr;
using testing::StartsWith;

struct Outcome {
  int exit_code = -1;
  std::string said;  // on both outputs
};

Outcome run(const std::string& arguments) {
  const std::string command = std::string(GS_OUTLET_PROGRAM) + " " + arguments + " 2>&1";
  std::FILE* const pipe = popen(command.c_str(), "r");
  Outcome outcome;
  std::array<char, 512> part{};
  while (std::fgets(part.data(), part.size(), pipe) != nullptr) {
    outcome.said += part.data();
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return outcome;
}

class GsOutlet : public testing::Test {
 protected:
  void SetUp() override {
    gsbench::emulation::SharedMemorySettings settings;
    settings.id = "a";
    settings.counts_per_pu = 20000.0F;
    auto made = SharedMemoryFile::create(folder_.path().string(), settings);
    ASSERT_TRUE(made.ok()) << made.error();
    file_.emplace(made.take());
    auto cable = NullModem::create();
    ASSERT_TRUE(cable.ok()) << cable.error();
    cable_.emplace(cable.take());
  }

  // Bad usage has an exit code of its own, its reason in one line, and a way to more.
  static void expect_refused(const std::string& arguments, const std::string& why) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.said, StartsWith("gs-outlet: " + why)) << arguments;
    EXPECT_THAT(outcome.said, testing::EndsWith("; `gs-outlet --help` says more\n")) << arguments;
  }

  std::string at_terminals() const {
    return " --terminals " + file_->path() + " --doorbell " + file_->doorbell();
  }

  std::string line_address() const { return "127.0.0.1:" + std::to_string(cable_->outlet_end()); }
  std::string line() const { return "--tcp " + line_address(); }

  TemporaryFolder folder_;
  std::optional<SharedMemoryFile> file_;
  std::optional<NullModem> cable_;
};

TEST_F(GsOutlet, SaysHowItIsUsed) {
  const Outcome outcome = run("--help");
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* option : {"--tcp", "--mqtt", "--ca", "--user", "--password-file", "--terminals",
                             "--doorbell", "Example:"}) {
    EXPECT_THAT(outcome.said, HasSubstr(option));
  }
}

TEST_F(GsOutlet, RefusesWhatItDoesNotUnderstand) {
  for (const std::string wrong : {"--nonsense", "--tcp", "something"}) {
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.exit_code, 2) << wrong;
    EXPECT_THAT(outcome.said, HasSubstr("gs-outlet: ")) << wrong;
    EXPECT_THAT(outcome.said, HasSubstr("`gs-outlet --help` says more")) << wrong;
  }
}

TEST_F(GsOutlet, WantsOneLine) {
  expect_refused(at_terminals(), "one of --tcp and --mqtt is needed");
  expect_refused("--tcp 127.0.0.1:1 --mqtt mqtt://127.0.0.1:1" + at_terminals(),
                 "one of --tcp and --mqtt is needed");
}

TEST_F(GsOutlet, RefusesALineThatIsNone) {
  cable_->unplug();
  expect_refused(line() + at_terminals(), line_address() + ": Connection refused");
  for (const std::string wrong : {"127.0.0.1", "127.0.0.1:", "127.0.0.1:70000", "localhost:5000"}) {
    expect_refused("--tcp " + wrong + at_terminals(), "\"" + wrong + "\" is no address:port");
  }
  expect_refused("--mqtt 127.0.0.1" + at_terminals(), "\"127.0.0.1\" is no mqtts://host:port");
  expect_refused("--mqtt mqtts://127.0.0.1:1 --ca /nowhere/ca" + at_terminals(),
                 "the CA file \"/nowhere/ca\" cannot be read");
  expect_refused("--mqtt mqtt://127.0.0.1:1 --password-file /nowhere/password" + at_terminals(),
                 "/nowhere/password: cannot be read");
}

TEST_F(GsOutlet, RefusesTerminalsThatAreNone) {
  expect_refused(line() + " --terminals /nowhere/file --doorbell " + file_->doorbell(),
                 "/nowhere/file: No such file or directory");
  const std::string other = folder_.write("other", "something else");
  expect_refused(line() + " --terminals " + other + " --doorbell " + file_->doorbell(),
                 other + ": holds no terminals");
  const std::string unmade =
      folder_.write("unmade", std::string(sizeof(gs::shared_memory_io::SharedMemory), '\0'));
  expect_refused(line() + " --terminals " + unmade + " --doorbell " + file_->doorbell(),
                 unmade + ": holds no terminals");
}

TEST_F(GsOutlet, RefusesADoorbellThatIsNone) {
  const std::string start = line() + " --terminals " + file_->path();
  expect_refused(start + " --doorbell /nowhere/bell", "/nowhere/bell: No such file or directory");
  expect_refused(start + " --doorbell /" + std::string(200, 'x'),
                 "/" + std::string(200, 'x') + ": too long for a socket");
}

TEST_F(GsOutlet, RefusesHardwareThatTheFirmwareDoesNotServe) {
  file_->terminals().sample_rate_hz = 100;
  expect_refused(line() + at_terminals(),
                 "the terminals are of hardware that the firmware does not serve");
}

TEST_F(GsOutlet, EndsWhenItIsToldTo) {
  const Outcome outcome =
      run(line() + at_terminals() + " & pid=$!; sleep 0.3; kill $pid; wait $pid");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.said;
}

TEST_F(GsOutlet, EndsWhenTheBenchIsGone) {
  auto child = Child::start({{GS_OUTLET_PROGRAM, "--tcp", line_address(), "--terminals",
                              file_->path(), "--doorbell", file_->doorbell()},
                             ""});
  ASSERT_TRUE(child.ok()) << child.error();
  Child outlet = child.take();
  ASSERT_TRUE(until([&] {
    file_->ring();  // accepts its connection
    return file_->terminals().starts == 1;
  }));
  EXPECT_TRUE(outlet.running());
  file_.reset();
  EXPECT_TRUE(until([&] { return !outlet.running(); }));
}

}  // namespace
