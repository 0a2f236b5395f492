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

bool was_judged(const record::RunRecord& run) {
  return run.fault.empty() && !run.interrupted;
}

std::vector<record::Mark> kept_marks(const record::OutletRecord& outlet) {
  std::vector<record::Mark> marks;
  std::copy_if(outlet.marks.begin(), outlet.marks.end(), std::back_inserter(marks),
               [](const record::Mark& mark) {
                 return mark.kind == "event" || mark.kind == "decision" ||
                        mark.kind == "relay.sense" || mark.kind == "relay.reported";
               });
  return marks;
}

std::string kept_sentence(const record::RunRecord& run, const record::OutletRecord& outlet) {
  const std::vector<std::int64_t>& ticks = outlet.trace.tick;
  std::string text = ticks.empty()
                         ? "no measurement"
                         : fmt::format("{} measurement{}, up to {:.3f} s of {:.3f} s", ticks.size(),
                                       ticks.size() == 1 ? "" : "s", seconds(run, ticks.back()),
                                       seconds(run, run.duration_ticks));
  const std::vector<record::Mark> marks = kept_marks(outlet);
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
  for (const record::Mark& mark : outlet.marks) {
    const std::string value = mark_value(mark);
    const std::string note = mark_note(mark);
    text += fmt::format("{:.3f} s  {}: {}{}{}\n", seconds(run, mark.tick), mark_label(mark), value,
                        value.empty() || note.empty() ? "" : ", ", note);
  }
  return text;
}

}  // namespace gsbench::render
