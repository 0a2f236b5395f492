#include <record/store.hpp>

namespace gsbench::record {

void MemoryStore::append(const std::vector<Reports>& reports) {
  for (std::size_t i = 0; i < reports.size(); ++i) {
    outlets_.at(i).append(reports[i]);
  }
}

void MemoryStore::update_outlet(std::size_t i, const OutletRecord& outlet) {
  Reports reports = std::move(static_cast<Reports&>(outlets_.at(i)));
  outlets_[i] = outlet;
  static_cast<Reports&>(outlets_[i]) = std::move(reports);
}

}  // namespace gsbench::record
