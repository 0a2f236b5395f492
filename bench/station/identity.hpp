// Who and when: the parts of a record that differ from run to run, and those that name the build.
#pragma once

#include <string>

namespace gsbench::station {

std::string utc_now();  // ISO 8601, to the second
std::string
new_run_id();           // time and a random part: sorts by time, unique on one machine and off it
std::string version();  // of gsbench
std::string firmware_sha256();

}  // namespace gsbench::station
