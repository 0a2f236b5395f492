// What a plan plays, instant by instant, for the record.
#pragma once

#include <vector>

#include <profile/plan.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

std::vector<record::Mark> stimulus_marks(const profile::Plan& plan);

}  // namespace gsbench::station
