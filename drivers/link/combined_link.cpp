#include <link/combined_link.hpp>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;

Status CombinedLink::open() {
  close();
  for (const auto& link : links_) {
    if (Status opened = link->open(); !opened.ok()) {
      close();
      return opened;
    }
  }
  return Done{};
}

Status CombinedLink::send(const std::string& id, const gs::wire::Downlink& message) {
  const auto found = link_of_.find(id);
  return found != link_of_.end() ? found->second->send(id, message)
                                 : Error{"no outlet " + id + " has joined"};
}

Status CombinedLink::poll(Happenings& happenings) {
  for (const auto& link : links_) {
    const std::size_t before = happenings.changes.size();
    if (Status polled = link->poll(happenings); !polled.ok()) {
      return polled;
    }
    // A later outlet with the same id on another link does not replace the first.
    for (std::size_t i = before; i < happenings.changes.size(); ++i) {
      if (const auto* const joined = std::get_if<OutletPresence>(&happenings.changes[i])) {
        link_of_.emplace(joined->id, link.get());
      }
    }
  }
  return Done{};
}

std::vector<Fault> CombinedLink::of_all(std::vector<Fault> (Link::*faults)()) {
  std::vector<Fault> all;
  for (const auto& link : links_) {
    const std::vector<Fault> some = (link.get()->*faults)();
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

std::vector<Fault> CombinedLink::missing() {
  return of_all(&Link::missing);
}

std::vector<Fault> CombinedLink::unreachable() {
  return of_all(&Link::unreachable);
}

void CombinedLink::close() noexcept {
  link_of_.clear();
  for (const auto& link : links_) {
    link->close();
  }
}

}  // namespace gsbench::link
