// A station whose drivers do nothing: what a run then costs is the station's own.
#pragma once

#include <memory>

#include <profile/plan.hpp>
#include <station/station.hpp>

namespace gsbench::performance {

std::unique_ptr<station::Station> idle_station(const profile::Plan& plan, double block_s);

}  // namespace gsbench::performance
