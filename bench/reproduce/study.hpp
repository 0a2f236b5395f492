// What the sections of one reproduction share: grid, options, and the campaigns played so far.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <tuple>

#include <campaign/scenario.hpp>
#include <reproduce/reproduction.hpp>

namespace gsbench::reproduce {

using campaign::Execution;

constexpr double kLossMw = 500.0;
constexpr double kPuMw = 100.0;  // the paper's unit
constexpr double kNoiseHz = 0.01;

class Study {
 public:
  Study(const grid::Grid& grid, const Options& options) : grid_(grid), options_(options) {}

  const grid::Grid& grid() const { return grid_; }
  const Options& options() const { return options_; }

  // A campaign of 500 MW and ±0.01 Hz by the options' choices.
  campaign::EstimateOptions campaign(campaign::Mode mode) const;

  // Each campaign is played once, whichever tables want it. `campaign` is as the above but for
  // mode, law, instant, errors and start.
  const campaign::EstimateResult& result(const campaign::EstimateOptions& campaign,
                                         const Execution& execution);

 private:
  using Key =
      std::tuple<campaign::Mode, campaign::NoiseLaw, campaign::LossInstant, double, double, double>;

  const grid::Grid& grid_;
  const Options& options_;
  std::map<Key, campaign::EstimateResult> results_;
};

std::string text_of(campaign::NoiseLaw law);         // "uniform ±0.01 Hz"
std::string text_of(campaign::LossInstant instant);  // "loss on a report"
std::string text_of(const campaign::Counting& counting);

// The n-th of so many parts of the work: its progress is a part of the whole's.
Execution nth_of(const Execution& execution, int n, int all);

// A fleet's scenario, where it was not stopped before its end.
std::optional<campaign::ScenarioResult> play_whole(const grid::Grid& grid,
                                                   const campaign::Fleet& fleet,
                                                   const campaign::ScenarioOptions& options,
                                                   const Execution& execution);

}  // namespace gsbench::reproduce
