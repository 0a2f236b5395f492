// The plan of a recorded run, so that it can be judged again on any machine.
#pragma once

#include <profile/plan.hpp>
#include <record/run_record.hpp>

namespace gsbench::judge {

// Made from the texts of profile, grid and recording in the record; no file is read. The number of
// its outlets is the profile's, not the station's. Records of version 6 have no such texts: the
// grid of the same name is then used if it is the same, and recordings are refused. Throws
// profile::ConfigurationError, also if this version of gsbench does not take the profile.
profile::Plan plan_of(const record::RunRecord& head);

}  // namespace gsbench::judge
