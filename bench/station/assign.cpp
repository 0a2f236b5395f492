#include <algorithm>

#include <station/slot.hpp>

namespace gsbench::station {

std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots) {
  const auto is_named = [&](const Slot& slot) {
    return std::any_of(outlets.begin(), outlets.end(), [&](const profile::Outlet& outlet) {
      return outlet.id == slot.serial_number;
    });
  };
  std::vector<Slot> assigned;
  auto free = slots.begin();
  for (const profile::Outlet& outlet : outlets) {
    const auto own = std::find_if(slots.begin(), slots.end(), [&](const Slot& slot) {
      return slot.serial_number == outlet.id;
    });
    free = std::find_if_not(free, slots.end(), is_named);
    if (own != slots.end()) {
      assigned.push_back(*own);
    } else if (free != slots.end()) {
      assigned.push_back(*free++);
    }
  }
  return assigned;
}

}  // namespace gsbench::station
