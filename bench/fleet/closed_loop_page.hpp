// The sections of the page of `gsbench fleet` about the closed loop.
#pragma once

#include <fleet/closed_loop.hpp>
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

// Every strategy on this plan. Times count from the start of its signal.
record::PageSection strategies_section(const profile::Plan& plan, const Fleet& fleet,
                                       const ClosedLoopOptions& options,
                                       const campaign::Execution& execution);

}  // namespace gsbench::fleet
