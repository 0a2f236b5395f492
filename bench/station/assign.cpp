#include <algorithm>

#include <station/slot.hpp>

namespace gsbench::station {

std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots) {
  std::vector<Slot> named;
  std::vector<Slot> free;
  for (const Slot& slot : slots) {
    const bool is_named = std::any_of(outlets.begin(), outlets.end(), [&](const auto& outlet) {
      return outlet.id == slot.serial_number;
    });
    (is_named ? named : free).push_back(slot);
  }
  std::vector<Slot> assigned;
  auto next = free.begin();
  for (const profile::Outlet& outlet : outlets) {
    const auto own = std::find_if(named.begin(), named.end(), [&](const Slot& slot) {
      return slot.serial_number == outlet.id;
    });
    if (own != named.end()) {
      assigned.push_back(*own);
    } else if (next != free.end()) {
      assigned.push_back(*next++);
    }
  }
  return assigned;
}

}  // namespace gsbench::station
