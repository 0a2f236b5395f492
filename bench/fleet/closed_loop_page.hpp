// The sections of the page of `gsbench fleet` about the closed loop.
#pragma once

#include <fleet/closed_loop.hpp>
#include <fleet/limits.hpp>
#include <fleet/page.hpp>

namespace gsbench::fleet {

constexpr std::size_t kClosedLoopOutlets = 1000;

constexpr const char* kTooLate =
    "No threshold loss allows for the delay: the nadir is below f_s even if all of the lost "
    "power is shed.";

// The threshold loss that allows for the delay until the last action.
double delay_aware_threshold_mw(const grid::Grid& grid, double loss_mw, double last_action_s);

// One loss, with the threshold loss of eq. (15) and with one that allows for the delay.
record::PageSection closed_loop_section(const grid::Grid& grid, const Study& study,
                                        const campaign::Execution& execution);

// The same loss, by every strategy.
record::PageSection strategies_after_loss(const grid::Grid& grid, const Study& study,
                                          const campaign::Execution& execution);

// Every strategy on this plan, in the order of all_strategies(). Fewer if `execution` was stopped.
std::vector<StrategyResult> simulate_strategies(const profile::Plan& plan, const Fleet& fleet,
                                                const ClosedLoopOptions& options,
                                                const campaign::Execution& execution);

// `results`: of all strategies.
const std::optional<ClosedLoopResult>& result_of(const std::vector<StrategyResult>& results,
                                                 Strategy strategy);

// A row for each. Times count from the start of the plan's signal.
record::FigureTable strategies_table(const profile::Plan& plan, const Fleet& fleet,
                                     const std::vector<StrategyResult>& results);

record::PageSection strategies_section(const profile::Plan& plan, const Fleet& fleet,
                                       const ClosedLoopOptions& options,
                                       const std::vector<StrategyResult>& results);

// The fleet and options of a plan: fewer outlets than in the study, with the seed of the plan.
Fleet fleet_of(const profile::Plan& plan, const Study& study);
ClosedLoopOptions options_of(const Study& study);

// Shows the progress of a part of the work as a part of all. `execution` must outlive the result.
campaign::Execution part_of(const campaign::Execution& execution, double done, double own,
                            double all);

// Of a strategy with outlets beside the clairvoyants. Not judged if one of them is missing, because
// the lost power is not known or the work was stopped.
record::Judgement judgement_of(const profile::Plan& plan,
                               const std::vector<StrategyResult>& results, Strategy strategy);

// How the limits follow from the clairvoyants.
std::string limits_note();

}  // namespace gsbench::fleet
