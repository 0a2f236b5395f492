// The curves of an HTML report, for its script (templates/report.js).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <render/view.hpp>

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
// `outlet` is the one with this index, with its marks.
OutletCurves curves_of(const View& view, std::size_t index, const record::OutletRecord& outlet,
                       std::size_t most_bytes);
std::string plot_data(const record::RunRecord& run, const std::vector<OutletCurves>& outlets);

// "Event", "Relay, sensed"; the kind itself if it has no label.
std::string mark_label(const record::Mark& mark);

// "310.4 MW", "open"; empty if the kind has no value.
std::string mark_value(const record::Mark& mark);

// What the value does not say: "frequency before it".
std::string mark_note(const record::Mark& mark);

// States that not all reports are drawn; empty if all are.
std::string thinning_note(const std::vector<OutletCurves>& outlets);

}  // namespace gsbench::render
