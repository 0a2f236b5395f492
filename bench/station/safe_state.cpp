#include <station/safe_state.hpp>

namespace gsbench::station {

SafeState::~SafeState() {
  source_.make_safe();
  link_.close();
}

}  // namespace gsbench::station
