// Where an outlet is on a station, and what the bench can reach of it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <profile/plan.hpp>

namespace gsbench::station {

struct Slot {
  std::string place;                         // for people
  std::string serial_number;                 // of the outlet in it
  std::optional<std::string> link_id;        // none: it offers nothing but its contact
  std::optional<std::size_t> relay_channel;  // of the station's relay sense; none: not watched
};

// One for each outlet of a plan, in the plan's order: the slot with the outlet's id for its serial
// number, else the next that no outlet of the plan names. Fewer than outlets where there are no
// more.
std::vector<Slot> assign(const std::vector<profile::Outlet>& outlets,
                         const std::vector<Slot>& slots);

}  // namespace gsbench::station
