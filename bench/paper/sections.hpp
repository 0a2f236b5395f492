// The sections of one reproduction, and what they share: grid, options, and the campaigns played so
// far.
#pragma once

#include <map>
#include <string>
#include <tuple>

#include <paper/reproduction.hpp>
#include <record/page.hpp>

namespace gsbench::paper {

using campaign::Execution;
using record::PageSection;

constexpr double kLoss_mw = 500.0;
constexpr double kPu_mw = 100.0;  // the paper's unit
constexpr double kNoise_hz = 0.01;

// How columns and rows are named. The firmware's estimators and conditions are the shipped code,
// but no outlet runs with an event that is known to the report.
constexpr const char* kPaperWay = "paper's way";
constexpr const char* kFirmware = "firmware at a known event";
constexpr const char* kReconciled = "experiment: firmware, parameters reconciled";

struct Study {
  // A campaign of 500 MW and ±0.01 Hz by the options' choices.
  campaign::EstimateOptions campaign(campaign::Mode mode, double parameter_error = 0.0) const;

  // Each campaign is played once, whichever tables want it. `campaign` is as the above but for
  // mode, distribution, instant, errors and start.
  const campaign::EstimateResult& result(const campaign::EstimateOptions& campaign,
                                         const Execution& execution);

  const grid::Grid& grid;
  const Options& options;
  std::map<std::tuple<campaign::Mode, campaign::NoiseDistribution, campaign::LossInstant, double,
                      double, double>,
           campaign::EstimateResult>
      results = {};
};

// A row's or column's name by what it was computed with.
std::string name_of(campaign::Mode mode, double parameter_error = 0.0);
std::string text_of(campaign::NoiseDistribution distribution);  // "uniform ±0.01 Hz"
std::string text_of(campaign::LossInstant instant);             // "loss on a report"
std::string text_of(const campaign::Counting& counting);

// The n-th of so many parts of the work: its progress is a part of the whole's.
Execution nth_of(const Execution& execution, int n, int all);

// One function a section, or a few that share their figures.
PageSection fig8_and_13(Study& study, const Execution& execution);
PageSection fig9_and_table1(Study& study, const Execution& execution);
PageSection fig14(Study& study, const Execution& execution);
PageSection table2(Study& study, const Execution& execution);
PageSection table3(Study& study, const Execution& execution);
PageSection fig16(Study& study, const Execution& execution);
PageSection table4(Study& study, const Execution& execution);
PageSection table5(Study& study, const Execution& execution);
PageSection fig19(Study& study, const Execution& execution);
PageSection fig20_and_21(Study& study, const Execution& execution);
PageSection fig22(Study& study, const Execution& execution);

}  // namespace gsbench::paper
