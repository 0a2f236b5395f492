#include <link/link.hpp>

namespace gsbench::link {

void Happenings::append(const Happenings& more) {
  joined.insert(joined.end(), more.joined.begin(), more.joined.end());
  left.insert(left.end(), more.left.begin(), more.left.end());
  messages.insert(messages.end(), more.messages.begin(), more.messages.end());
  faults.insert(faults.end(), more.faults.begin(), more.faults.end());
}

}  // namespace gsbench::link
