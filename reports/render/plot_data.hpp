// The curves of an HTML report as the script in it takes them (templates/report.js).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

constexpr std::size_t kMostPoints = 4000;  // of one curve
constexpr std::size_t kMostMarks = 200;    // of one outlet

// JSON that may stand inside <script>: no "<", ">" or "&" occurs in it.
std::string plot_data(const record::RunRecord& run);

// Which entries of a long series a plot needs: the extremes of each stretch of it, so that a
// thinned curve looks like the whole one and hides no spike.

struct Stretch {
  std::int64_t from_tick;
  std::int64_t to_tick;
};

// Indices of the entries to keep, ascending, at most `most` (which is at least 20). All of them
// where they are not more. Otherwise: the first and the last; every entry within `whole` stretches,
// in their order while half of `most` lasts; and in equal parts of the rest least and greatest of
// both columns and the first NaN (a gap stays a gap).
std::vector<std::size_t> thinned(const std::vector<std::int64_t>& tick,
                                 const std::vector<double>& first,
                                 const std::vector<double>& second,
                                 const std::vector<Stretch>& whole, std::size_t most);

// "Event", "Relay, sensed"; the kind itself where there is no better word.
std::string mark_label(const record::Mark& mark);

// "310.4 MW", "open"; empty where the kind alone says it.
std::string mark_value(const record::Mark& mark);

// What is drawn where not all is; empty where all is.
std::string thinning_note(const record::RunRecord& run);

}  // namespace gsbench::render
