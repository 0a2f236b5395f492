// One measurement of kLanes outlets of a fleet.
#pragma once

#include "lanes.hpp"

#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {

// `report` counts from the event's own, 0.
void take_report(const gs::outlet::Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report);

}  // namespace gsbench::campaign
