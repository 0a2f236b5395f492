// The curves of an HTML report as the script in it takes them (templates/report.js).
#pragma once

#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

constexpr std::size_t kMostPoints = 4000;  // of one curve
constexpr std::size_t kMostMarks = 200;    // of one outlet

// JSON that may stand inside <script>: no "<", ">" or "&" occurs in it.
std::string plot_data(const record::RunRecord& run);

// "Event", "Relay, sensed"; the kind itself where there is no better word.
std::string mark_label(const record::Mark& mark);

// "310.4 MW", "open"; empty where the kind alone says it.
std::string mark_value(const record::Mark& mark);

// What is drawn where not all is; empty where all is.
std::string thinning_note(const record::RunRecord& run);

}  // namespace gsbench::render
