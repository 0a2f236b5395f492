#include <algorithm>

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
  first_ = {0};
  at_fault_.clear();
  for (const auto& link : links_) {
    const auto present = link->open();
    if (!present.ok()) {
      close();
      return Error{present.error()};
    }
    all.insert(all.end(), present.value().begin(), present.value().end());
    first_.push_back(all.size());
  }
  mark_twins(all);
  for (const OutletPresence& outlet : all) {
    at_fault_.push_back(!outlet.fault.empty());
  }
  return all;
}

Status CombinedLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  for (std::size_t i = 0; i + 1 < first_.size(); ++i) {
    if (outlet >= first_[i] && outlet < first_[i + 1]) {
      if (at_fault_[outlet]) {
        return Done{};
      }
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
  const auto at_fault = [this](const auto& said) { return at_fault_[said.outlet]; };
  messages.erase(std::remove_if(messages.begin(), messages.end(), at_fault), messages.end());
  faults.erase(std::remove_if(faults.begin(), faults.end(), at_fault), faults.end());
  return Done{};
}

void CombinedLink::close() noexcept {
  first_.clear();
  at_fault_.clear();
  for (const auto& link : links_) {
    link->close();
  }
}

}  // namespace gsbench::link
