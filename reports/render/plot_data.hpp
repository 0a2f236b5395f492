// The curves of an HTML report, for its script (templates/report.js).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

constexpr std::size_t kMostPoints = 4000;  // of one curve
constexpr std::size_t kMostMarks = 200;    // of one outlet

// JSON texts for a <script> element, without "<", ">" and "&".
struct OutletCurves {
  std::string json;
  std::size_t reports;  // of the outlet
  std::size_t drawn;    // at most so many of them
};
// Draws fewer points if the text would be longer than `most_bytes`.
OutletCurves curves_of(const record::RunRecord& run, const record::OutletRecord& outlet,
                       std::size_t most_bytes);
std::string plot_data(const record::RunRecord& run, const std::vector<OutletCurves>& outlets);

// Thinning selects the entries of a long series that a plot needs: the extremes of each interval.
// The thinned curve looks like the complete one, and no spike is lost.

struct Stretch {
  std::int64_t from_tick;
  std::int64_t to_tick;
};

// Indices of the entries to keep, ascending, at most `most`. `most` is at least 20. If the series
// has no more entries than that, all are kept. Otherwise these are kept:
// - the first and the last entry;
// - every entry within the stretches of `whole`, in their order, up to half of `most`;
// - from each of equal parts of the series, the minimum and maximum of both columns, and the first
//   NaN, so that gaps stay gaps.
std::vector<std::size_t> thinned(const std::vector<std::int64_t>& tick,
                                 const std::vector<double>& first,
                                 const std::vector<double>& second,
                                 const std::vector<Stretch>& whole, std::size_t most);

// "Event", "Relay, sensed"; the kind itself if it has no label.
std::string mark_label(const record::Mark& mark);

// "310.4 MW", "open"; empty if the kind has no value.
std::string mark_value(const record::Mark& mark);

// What the value does not say: "frequency before it".
std::string mark_note(const record::Mark& mark);

// States that not all reports are drawn; empty if all are.
std::string thinning_note(const std::vector<OutletCurves>& outlets);

}  // namespace gsbench::render
