// What a report shows of a run. Reports of outlets are read one outlet at a time and in pieces: a
// run may have more of them than fit into memory.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

struct View {
  // All outlets of a run that has their reports.
  View(const record::RunRecord& run);  // NOLINT(google-explicit-constructor): a run is a view

  const record::RunRecord& run;      // has the results of all outlets; reports are not used
  std::vector<std::size_t> outlets;  // that are shown: indices in run.outlets
  // The outlet with this index, with its marks and what it was sent, and all of its reports in
  // pieces. Both may throw what the reader of a record throws.
  std::function<record::OutletRecord(std::size_t index)> marked;
  std::function<void(std::size_t index, const record::TakeReports& take)> read_reports;
};

// At most `most` of the outlets that are shown. If that is not all of them, the worst come first:
// by verdict, then by the number of measurements that did not pass, then one of each group in turn.
std::vector<std::size_t> worst_first(const View& view, std::size_t most);

// All outlets that are shown, in that order.
std::vector<std::size_t> worst_first(const View& view);

// Takes the parts of a text in order.
using Sink = std::function<void(std::string_view part)>;

}  // namespace gsbench::render
