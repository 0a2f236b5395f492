// Reads the parts of a record. Every function throws StoreError if the record is damaged.
#pragma once

#include "schema.hpp"

#include <string>

namespace gsbench::record {

// All seals of outlets, in order.
std::string seals_of_outlets(Database& database);

// Without outlets. `complete`: finish() was called.
RunRecord read_head(Database& database, const StoredFields& stored, bool& complete);

// Of outlet `number`, from 1, not yet placed on the run's time: without reports, with marks and
// what was sent, and the reports in pieces. Only the last checks the digests of marks.
OutletRecord read_results(Database& database, const StoredFields& stored, std::size_t number);
OutletRecord read_marked(Database& database, const StoredFields& stored, std::size_t number);
void read_reports(Database& database, const StoredFields& stored, std::size_t number,
                  const TakeReports& take);

}  // namespace gsbench::record
