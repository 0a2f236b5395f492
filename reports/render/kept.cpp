#include "kept.hpp"

#include "format.hpp"
#include "plot_data.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

constexpr std::size_t kMostKeptMarks = 10;  // in a sentence

const char* what(const record::Mark& mark) {
  if (mark.kind == "event" || mark.kind == "decision") {
    return mark.kind.c_str();
  }
  const bool open = mark.value == 0.0;
  return mark.kind == "relay.sense" ? (open ? "relay sensed open" : "relay sensed closed")
                                    : (open ? "relay reported open" : "relay reported closed");
}

}  // namespace

Kept kept_of(const View& view, std::size_t index) {
  Kept kept;
  view.read_reports(index, [&](const record::Reports& piece) {
    const std::vector<std::int64_t>& ticks = piece.trace.tick;
    kept.measurements += ticks.size();
    kept.last_tick = ticks.empty() ? kept.last_tick : ticks.back();
  });
  const std::vector<record::Mark> marks = view.marked(index).reports.marks;
  std::copy_if(marks.begin(), marks.end(), std::back_inserter(kept.marks),
               [](const record::Mark& mark) {
                 return mark.kind == "event" || mark.kind == "decision" ||
                        mark.kind == "relay.sense" || mark.kind == "relay.reported";
               });
  return kept;
}

std::string kept_sentence(const record::RunRecord& run, const Kept& kept) {
  std::string text =
      kept.measurements == 0
          ? "no measurement"
          : fmt::format("{} measurement{}, up to {:.3f} s of {:.3f} s", kept.measurements,
                        kept.measurements == 1 ? "" : "s", seconds(run, kept.last_tick),
                        seconds(run, run.duration_ticks));
  const std::vector<record::Mark>& marks = kept.marks;
  for (std::size_t i = 0; i < std::min(marks.size(), kMostKeptMarks); ++i) {
    text += fmt::format("; {} {:.3f} s", what(marks[i]), seconds(run, marks[i].tick));
  }
  if (marks.size() > kMostKeptMarks) {
    text += fmt::format("; … and {} more", marks.size() - kMostKeptMarks);
  }
  return text;
}

std::string kept_list(const record::RunRecord& run, const record::OutletRecord& outlet) {
  std::string text;
  for (const record::Mark& mark : outlet.reports.marks) {
    const std::string value = mark_value(mark);
    const std::string note = mark_note(mark);
    text += fmt::format("{:.3f} s  {}: {}{}{}\n", seconds(run, mark.tick), mark_label(mark), value,
                        value.empty() || note.empty() ? "" : ", ", note);
  }
  return text;
}

}  // namespace gsbench::render
