// Sentences on the verdict of a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <render/view.hpp>

namespace gsbench::render {

// One sentence: the reason of the verdict.
std::string verdict_sentence(const record::RunRecord& run);

// Why the verdict of an outlet is worse than those of its measurements: its fault, if known.
std::string outlet_sentence(const record::OutletRecord& outlet);

// False if instance and protocol version are not known: 0 is the instance of a simulated outlet.
bool has_sent_hello(const record::OutletRecord& outlet);

// Outlets with a fault, of those that are shown.
std::vector<const record::OutletRecord*> faulty_outlets(const View& view);

// What played the signal, how, and how accurately: lines. Empty if it was played exactly.
std::vector<std::string> source_lines(const record::RunRecord& run);
// The same in two lines, for a terminal: what is played, and the largest deviations.
std::vector<std::string> source_in_short(const record::RunRecord& run);

// False if all devices count the ticks of a source that plays exactly: nothing was aligned.
bool has_clocks(const record::RunRecord& run);
std::string clock_uncertainty(const record::AlignedClock& clock);  // "± 0.13 ms"

// Which recording was played; empty if none was.
std::string played_sentence(const record::RunRecord& run);
// How much of it was played, and how it was read; empty if none was, or for older records.
std::string played_part(const record::RunRecord& run);
// Key and TOML value of each option of a recording but its columns.
std::vector<std::pair<std::string, std::string>> recording_options(
    const record::Recording& recording);
// A profile gives a column by name or by number, which a record has as "#3"; nullopt: by name.
std::optional<std::uint64_t> column_number(const std::string& column);

// Judged measurements of the outlets that are shown that did not pass: one of each measure, then
// the others, each part by verdict and then in the order of worst_first().
struct Shortfall {
  const record::OutletRecord* outlet;
  const record::MeasurementResult* result;
};
std::vector<Shortfall> shortfalls(const View& view);

// "112.00 ± 0.13 ms, limit ≤ 100 ms: reason"
std::string shortfall_text(const record::MeasurementResult& result);

}  // namespace gsbench::render
