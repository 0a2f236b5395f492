#include "run_steps.hpp"
#include <sys/utsname.h>

#include <string>

namespace gsbench::station {

std::string software() {
  std::string all = GSBENCH_BUILT_WITH;
  utsname system{};
  if (::uname(&system) == 0) {
    all += std::string("\n") + system.sysname + " " + system.release + " " + system.machine;
  }
  return all;
}

}  // namespace gsbench::station
