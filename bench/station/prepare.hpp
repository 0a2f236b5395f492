// The head of a run's record: what is to be played, where and with what.
#pragma once

#include <profile/plan.hpp>
#include <record/run_record.hpp>
#include <station/station.hpp>

namespace gsbench::station {

// Throws profile::ConfigurationError where the firmware would refuse the settings of an outlet,
// before anything is touched: that is the profile's mistake.
record::RunRecord prepare(const profile::Plan& plan, Station& station);

}  // namespace gsbench::station
