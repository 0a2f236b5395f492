// An hour at nominal frequency with 1 % noise: nothing happens.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

namespace {

TEST(SteadyHour, PassesWithoutAnEvent) {
  const gsbench::test::TemporaryFolder folder;
  const gsbench::test::Outcome outcome =
      gsbench::test::run_gsbench({"run", "regression/steady", "--out", folder.path().string()});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
}

}  // namespace
