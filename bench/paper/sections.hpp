// The sections of one reproduction, and the data that they share: grid, options and the campaigns
// computed so far.
#pragma once

#include <cstdint>
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

// Names of columns and rows. "Firmware" uses the estimators and conditions of the shipped code.
// "Known event": the time of the event is given, while a shipped outlet has to detect the event.
constexpr const char* kPaperMethod = "paper's method";
constexpr const char* kFirmware = "firmware, known event";
constexpr const char* kReconciled = "experiment: reconciled parameters";

struct Study {
  // The options for a campaign with 500 MW and ±0.01 Hz.
  campaign::EstimateOptions campaign(campaign::Mode mode, double parameter_error = 0.0) const;

  // The result of a campaign. It is computed at the first call and then kept for the other tables.
  // `campaign` may differ from the options above only in mode, noise distribution, loss instant,
  // parameter error and initial deviations of the EKF.
  const campaign::EstimateResult& result(const campaign::EstimateOptions& campaign,
                                         const Execution& execution);

  const grid::Grid& grid;
  const Options& options;
  std::map<std::tuple<campaign::Mode, campaign::NoiseDistribution, campaign::LossInstant, double,
                      double, double>,
           campaign::EstimateResult>
      results = {};
};

// Names of rows and columns (name_of), and longer texts (text_of).
std::string name_of(campaign::Mode mode, double parameter_error = 0.0);
std::string name_of(campaign::NoiseDistribution distribution);  // "uniform"
std::string text_of(campaign::NoiseDistribution distribution);  // "uniform ±0.01 Hz"
std::string text_of(campaign::LossInstant instant);             // "on a report"
std::string text_of(const campaign::Counting& counting);

// How many decimals a figure with this standard error supports: the last decimal has the order of
// magnitude of the standard error.
int decimals_of(double standard_error, int most);

// Sets the decimals of a column of shares, given as 0 … whole. They follow from the largest
// standard error in the column: √(p(1 − p)/n) for a share p of n trajectories, at least 1/n.
void set_share_decimals(record::FigureTable& table, std::size_t column, double whole,
                        std::uint64_t trajectories);

// The execution of part n (from 0) of `all` equal parts of the work. Scales the progress of the
// part to progress of the whole.
Execution nth_of(const Execution& execution, int n, int all);

// One function for each section, or for two sections that share their figures.
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
