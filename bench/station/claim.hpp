// Each outlet of a plan gets one of the station's, with its settings.
#pragma once

#include <vector>

#include <link/link.hpp>
#include <profile/plan.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

// In the plan's order. An outlet that was found at fault, or that samples otherwise than the plan
// needs, has that fault and no settings. Throws BenchFault where there are too few.
std::vector<record::OutletRecord> claim(const profile::Plan& plan, link::Link& link);

}  // namespace gsbench::station
