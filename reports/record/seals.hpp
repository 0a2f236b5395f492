// The digests that a record has of its own content. Each covers the fields that are stored; with
// nullptr, all of this version.
#pragma once

#include "schema.hpp"

#include <string>

namespace gsbench::record {

// `seals_of_outlets`: all of them, in order; empty while the run is not complete.
std::string seal_of_run(const RunRecord& head, bool complete, const std::string& seals_of_outlets,
                        const StoredFields* stored = nullptr);

// Of all but the reports.
std::string seal_of_results(const OutletRecord& outlet, const StoredFields* stored = nullptr);

// Of one append. `before`: the seal of the append before it, or empty.
std::string seal_of_reports(const std::string& before, const Reports& reports,
                            const StoredFields* stored = nullptr);

// The one seal of an outlet in a record of version 6.
std::string seal_of_whole(const OutletRecord& outlet, const StoredFields& stored);

}  // namespace gsbench::record
