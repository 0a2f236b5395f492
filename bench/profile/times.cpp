#include "times.hpp"

namespace gsbench::profile {

keys::Key time_in_run(const char* meaning) {
  return keys::number("at_s", "s", keys::at_least(0.0), meaning)
      .permits("0 … before the end")
      .require();
}

keys::Range within_run(double duration_s) {
  keys::Range range = keys::between(0.0, duration_s);
  range.high_open = true;
  range.note = "the run's duration";
  return range;
}

}  // namespace gsbench::profile
