// What reports show of a stored run.
#pragma once

#include <string>
#include <vector>

#include <record/store.hpp>
#include <render/view.hpp>

namespace gsbench::cli {

// The results of a stored run. Of one that did not finish, the reason of the verdict says until
// when reports were kept. Throws record::StoreError.
record::RunRecord results_of(record::Reader& reader);

// Outlets take their results from `run` and their reports from the record; both must outlive the
// view. With ids, these outlets are shown, otherwise all. Throws profile::ConfigurationError if the
// run has no outlet with an id.
render::View view_of(const record::RunRecord& run, record::Reader& reader,
                     const std::vector<std::string>& ids = {});

}  // namespace gsbench::cli
