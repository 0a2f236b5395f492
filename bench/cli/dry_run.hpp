// `gsbench run --dry-run`: prints what a run would do.
#pragma once

#include <profile/plan.hpp>
#include <station/station.hpp>

namespace gsbench::cli {

// Returns an exit code. Throws profile::ConfigurationError for what a run would refuse.
int dry_run(const profile::Plan& plan, station::Station& station, bool json);

}  // namespace gsbench::cli
