#include "boot.hpp"

#include "faults.hpp"

#include <algorithm>
#include <cmath>
#include <thread>

#include <fmt/format.h>

namespace gsbench::station {
namespace {

constexpr auto kBetweenHolds = std::chrono::milliseconds(10);

}  // namespace

Boot::Boot(Station& station, const std::vector<Slot>& slots, const RunOptions& options)
    : station_(station),
      options_(options),
      linked_(static_cast<std::size_t>(std::count_if(
          slots.begin(), slots.end(), [](const Slot& slot) { return slot.link_id.has_value(); }))),
      needs_all_(linked_ < slots.size() || station.source().limits().kind == source::Kind::kLoaded),
      end_(std::chrono::steady_clock::now() + station.answers_within()) {}

double Boot::left_s() const {
  return std::max(std::chrono::duration<double>(end_ - std::chrono::steady_clock::now()).count(),
                  0.0);
}

drivers::Status Boot::hold(std::size_t joined) {
  const double seconds = std::ceil(left_s());
  if (options_.waiting && seconds > 0.0) {
    options_.waiting(
        joined < linked_
            ? fmt::format("waiting for outlets: {} of {} joined, {:.0f} s left", joined, linked_,
                          seconds)
            : fmt::format("nominal voltage for outlets to boot: {:.0f} s left", seconds));
  }
  return station_.source().hold();
}

void Boot::keep_up(std::size_t joined) {
  require(station_.source(), hold(joined));
}

void Boot::finish() {
  while (needs_all_ && left_s() > 0.0) {
    keep_up(linked_);
    std::this_thread::sleep_for(kBetweenHolds);
  }
}

}  // namespace gsbench::station
