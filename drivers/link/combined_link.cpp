#include <map>

#include <link/combined_link.hpp>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

std::string CombinedLink::name() const {
  std::string name;
  for (const auto& link : links_) {
    name += (name.empty() ? "" : " and ") + link->name();
  }
  return name;
}

Result<std::vector<OutletPresence>> CombinedLink::open() {
  std::vector<OutletPresence> all;
  std::map<std::string, std::string> where;
  first_ = {0};
  for (const auto& link : links_) {
    const auto present = link->open();
    if (!present.ok()) {
      return Error{present.error()};
    }
    for (const OutletPresence& outlet : present.value()) {
      const auto [other, is_first] = where.emplace(outlet.id, outlet.where);
      if (!is_first) {
        return Error{"two outlets say they are " + outlet.id + ": on " + other->second +
                     " and on " + outlet.where};
      }
      all.push_back(outlet);
    }
    first_.push_back(all.size());
  }
  return all;
}

Status CombinedLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
    if (outlet >= first_[i] && outlet < first_[i + 1]) {
      return links_[i]->send(outlet - first_[i], message);
    }
  }
  return Error{"no outlet " + std::to_string(outlet)};
}

Status CombinedLink::poll(std::vector<Received>& messages, std::vector<Fault>& faults) {
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
    const std::size_t old_messages = messages.size();
    const std::size_t old_faults = faults.size();
    Status status = links_[i]->poll(messages, faults);
    if (!status.ok()) {
      return status;
    }
    for (std::size_t m = old_messages; m < messages.size(); ++m) {
      messages[m].outlet += first_[i];
    }
    for (std::size_t f = old_faults; f < faults.size(); ++f) {
      faults[f].outlet += first_[i];
    }
  }
  return Done{};
}

void CombinedLink::close() noexcept {
  for (const auto& link : links_) {
    link->close();
  }
}

}  // namespace gsbench::link
