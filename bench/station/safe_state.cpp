#include <station/safe_state.hpp>

namespace gsbench::station {

SafeState::~SafeState() {
  const drivers::Status safe = source_.make_safe();
  link_.close();
  if (!safe.ok()) {
    fault_ += (fault_.empty() ? "" : "; ") + ("the source may still be live: " + safe.error());
  }
}

}  // namespace gsbench::station
