#include "faults.hpp"

#include <algorithm>
#include <utility>

namespace gsbench::station {

void require_an_outlet(const std::vector<record::OutletRecord>& outlets) {
  if (std::all_of(outlets.begin(), outlets.end(),
                  [](const record::OutletRecord& outlet) { return !outlet.fault.empty(); })) {
    throw BenchFault(first_fault(outlets) + "; no outlet is left");
  }
}

void note(record::OutletRecord& outlet, const std::string& fault) {
  if (outlet.fault.empty()) {
    outlet.fault = fault;
  }
}

std::string first_fault(const std::vector<record::OutletRecord>& outlets) {
  for (const record::OutletRecord& outlet : outlets) {
    if (!outlet.fault.empty()) {
      return "outlet " + outlet.id + " " + outlet.fault;
    }
  }
  return {};
}

std::string failed_parts(std::uint32_t failed) {
  std::string names;
  for (const auto& [part, name] : {std::pair(gs::wire::kArithmetic, "arithmetic"),
                                   {gs::wire::kSettingsStorage, "settings storage"},
                                   {gs::wire::kClock, "crystal"}}) {
    if ((failed & part) != 0) {
      names += (names.empty() ? "" : ", ") + std::string(name);
    }
  }
  return names;
}

bool spoils_a_run(gs::wire::ErrorCode error) {
  return error == gs::wire::ErrorCode::kSamplesLost || error == gs::wire::ErrorCode::kWatchdog ||
         error == gs::wire::ErrorCode::kSettingsStorage || error == gs::wire::ErrorCode::kClock;
}

}  // namespace gsbench::station
