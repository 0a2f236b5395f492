#include <record/store.hpp>

namespace gsbench::record {

void MemoryStore::append(const std::vector<Reports>& reports) {
  for (std::size_t i = 0; i < reports.size(); ++i) {
    outlets_.at(i).reports.append(reports[i]);
  }
}

void MemoryStore::update_outlet(std::size_t i, const OutletRecord& outlet) {
  Reports reports = std::move(outlets_.at(i).reports);
  outlets_[i] = outlet;
  outlets_[i].reports = std::move(reports);
}

OutletRecord MemoryStore::outlet(std::size_t i) {
  OutletRecord outlet = outlets_.at(i);
  outlet.reports.trace = {};
  outlet.reports.estimates = {};
  return outlet;
}

}  // namespace gsbench::record
