// What commands print with --json.
#include "gsbench_process.hpp"

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

using nlohmann::ordered_json;

class JsonOutput : public testing::TestWithParam<Words> {};

INSTANTIATE_TEST_SUITE_P(OfCommands, JsonOutput,
                         testing::Values(Words{"list"}, Words{"measures"},
                                         Words{"params", "ieee24"},
                                         Words{"run", "regression/steady", "--dry-run"},
                                         Words{"study", "regression/steady", "--seeds", "2"},
                                         Words{"compare", "regression/equivalence", "--station",
                                               "simulated", "--station", "simulated"},
                                         Words{"immunity", "--cases", "2"},
                                         Words{"reproduce", "--only", "table2"}));

TEST_P(JsonOutput, HasItsFormatVersionFirst) {
  Words words = GetParam();
  words.emplace_back("--json");
  const Outcome outcome = run_gsbench(words);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const ordered_json printed = ordered_json::parse(outcome.out);
  for (const ordered_json& object : printed.is_array() ? printed : ordered_json{printed}) {
    EXPECT_EQ(object.begin().key(), "format_version");
    EXPECT_EQ(object.begin().value(), 1);
  }
}

}  // namespace
}  // namespace gsbench::test
