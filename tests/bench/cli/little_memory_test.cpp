// Little memory, and threads that the system does not give: never an abort.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench_within;
using gsbench::test::TemporaryFolder;

constexpr std::uint64_t kMegabyte = 1U << 20U;

// Each thread asks for 8 MB of stack: 256 of them are too many for all of these.
class LittleMemory : public testing::TestWithParam<std::uint64_t> {};

TEST_P(LittleMemory, EndsWithAResultOrTellsThatItWasTooLittle) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "a sanitizer takes terabytes of address space";
#endif
  const TemporaryFolder folder;
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"study", "paper/loss-500mw", "--seeds", "2", "--threads", "256"},
           {"run", "paper/loss-500mw", "--threads", "256", "--out", folder.file("runs")}}) {
    const Outcome outcome = run_gsbench_within(GetParam() * kMegabyte, arguments);
    if (outcome.exit_code != 0) {
      EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
      EXPECT_NE(outcome.err.find("out of memory"), std::string::npos) << outcome.err;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Megabytes, LittleMemory, testing::Values(150U, 400U, 1000U));

}  // namespace
