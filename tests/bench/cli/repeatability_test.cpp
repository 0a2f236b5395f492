// Equal profiles and seeds give equal bytes with any number of threads.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

#include <render/render.hpp>

namespace gsbench::test {
namespace {

struct Result {
  std::string traces;
  std::string result;  // without the run's id
};

Result run_with(const std::string& seed, const std::string& threads) {
  const TemporaryFolder folder;
  const Outcome outcome = run_gsbench({"run", "paper/loss-500mw", "--seed", seed, "--threads",
                                       threads, "--csv", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  const std::filesystem::path run = only_run(folder.path());
  nlohmann::ordered_json result = nlohmann::ordered_json::parse(text_of(run / "result.json"));
  result.erase("run_id");
  return {text_of(run / "traces.csv"), result.dump()};
}

TEST(Repeatability, ResultsDoNotDependOnThreads) {
  const Result one = run_with("7", "1");
  EXPECT_GT(one.traces.size(), 100000U);
  for (const std::string threads : {"1", "2", "3", "8"}) {
    const Result again = run_with("7", threads);
    EXPECT_TRUE(one.traces == again.traces) << threads << " threads";
    EXPECT_EQ(one.result, again.result) << threads << " threads";
  }
}

TEST(Repeatability, ADifferentSeedGivesDifferentTraces) {
  EXPECT_FALSE(run_with("7", "1").traces == run_with("8", "1").traces);
}

TEST(Repeatability, AReportThatIsRenderedAgainIsEqual) {
  const TemporaryFolder folder;
  const Outcome ran =
      run_gsbench({"run", "paper/loss-600mw", "--csv", "--out", folder.path().string()});
  ASSERT_EQ(ran.exit_code, 0);
  const std::filesystem::path run = only_run(folder.path());
  for (const gsbench::render::Format& format : gsbench::render::kFormats) {
    const Outcome again = run_gsbench({"report", run.string(), "--format", format.name});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    const bool has_file = format.file[0] != '\0';
    const std::string before =
        has_file ? text_of(run / format.file) : ran.out.substr(0, ran.out.find("\nReport: "));
    EXPECT_TRUE(again.out == before) << format.name;
  }
}

}  // namespace
}  // namespace gsbench::test
