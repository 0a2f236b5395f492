// Each outlet of a plan gets one of the station's, with its settings.
#pragma once

#include <vector>

#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <station/slot.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// In the plan's order, each in its slot. One that does not answer, was found at fault, or samples
// otherwise than the plan needs, has that fault and no settings; one without a link has no settings
// either. Throws BenchFault where there are too few slots.
std::vector<record::OutletRecord> claim(const profile::Plan& plan, const std::vector<Slot>& slots,
                                        Station& station);

}  // namespace gsbench::station
