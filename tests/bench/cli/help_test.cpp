#include "gsbench_process.hpp"

#include <gtest/gtest.h>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;

TEST(Help, EverySubcommandHasOneWithAnExample) {
  for (const std::string command : {"run", "list", "check", "params", "waveform", "report", "runs",
                                    "study", "measures", "reproduce", "fleet"}) {
    const Outcome outcome = run_gsbench({command, "--help"});
    EXPECT_EQ(outcome.exit_code, 0) << command;
    EXPECT_NE(outcome.out.find("gsbench " + command), std::string::npos) << outcome.out;
    EXPECT_NE(outcome.out.find("Example"), std::string::npos) << command;
  }
}

TEST(Help, NamesEverySubcommandAndTheExitCodes) {
  const Outcome outcome = run_gsbench({"--help"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const std::string word : {"run", "list", "check", "params", "waveform", "report", "runs",
                                 "study", "measures", "reproduce", "fleet", "INCONCLUSIVE"}) {
    EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
  }
}

TEST(Help, AListNamesWhatIsShipped) {
  const Outcome outcome = run_gsbench({"list"});
  for (const std::string name : {"paper/loss-500mw", "events/gb-2019", "disturbances/dead-bus",
                                 "ieee24-by-unit", "island-60hz"}) {
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
  }
}

}  // namespace
