// `gsbench immunity` in a short form: 400 cases of each kind, and in another grid.
#include <gtest/gtest.h>

#include <immunity/study.hpp>
#include <profile/load.hpp>

namespace gsbench::immunity {
namespace {

class ManyCases : public testing::TestWithParam<const char*> {};

TEST_P(ManyCases, HaveNoTripAndAtMostOneEventInThousandDips) {
  const grid::Grid grid = profile::load_grid(GetParam());
  Options options;
  options.cases = static_cast<std::uint32_t>(400 * kKinds.size());
  campaign::Execution execution;
  execution.threads = 2;
  const SettledOutlets outlets(grid, options, execution);
  const auto drawn = [&](std::uint32_t number) {
    return draw(grid.nominal_hz, options.seed, number);
  };
  const Result result = play_all(outlets, drawn, execution);
  EXPECT_EQ(result.all().cases, options.cases);
  EXPECT_TRUE(result.passes());
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    EXPECT_EQ(result.kinds[i].trips, 0U)
        << kKinds[i].name << ", case " << result.kinds[i].first_failing.value_or(0);
  }
  EXPECT_LE(result.dips().events, kMostEventsOfDips * result.dips().cases);
}

INSTANTIATE_TEST_SUITE_P(Grids, ManyCases, testing::Values("ieee24", "island-60hz"),
                         [](const auto& grid) { return std::string(grid.param).substr(0, 6); });

}  // namespace
}  // namespace gsbench::immunity
