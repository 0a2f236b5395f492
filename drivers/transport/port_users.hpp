// Who has a device open.
#pragma once

#include <string>

namespace gsbench::transport {

// "process 4711 (picocom)" for a process that has the device open, other than by a descriptor of
// this object's own (`except`, of this process). Empty: none that this user may see. `device`: a
// path without symbolic links. Reads /proc.
std::string user_of(const std::string& device, int except);

}  // namespace gsbench::transport
