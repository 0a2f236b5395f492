#include "counts.hpp"
#include "format.hpp"
#include "kept.hpp"
#include "key_figures.hpp"
#include "summary.hpp"
#include "terminal_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostTerminalColumns = 7;  // of key figures
constexpr std::size_t kMostOutletRows = 32;      // more outlets are counted

// The most lines of each kind and in all; the HTML report has more.
struct Most {
  std::size_t outlets;
  std::size_t groups;
  std::size_t faults;
  std::size_t shortfalls;
  std::size_t clocks;
  std::size_t lines;
  std::size_t columns;     // of a line; longer ones are shortened in the middle
  std::size_t id_columns;  // likewise of an id in a line
};
constexpr std::size_t kAll = TerminalText::kAll;
constexpr Most kMostOfFew{kAll, kAll, 10, 10, kAll, kAll, kAll, kAll};
// Shortfalls have the lines that the other kinds leave: those take 35 at most.
constexpr Most kMostOfMany{6, 5, 3, kAll, 1, 38, kLineColumns, kMostIdColumns};

// Two lines of headings, then a line for each outlet, its verdict at the end.
std::vector<std::string> table_of(const Outlets& outlets, const std::vector<KeyColumn>& columns) {
  std::vector<std::vector<std::string>> rows = {{""}, {"outlet"}};
  for (const KeyColumn& column : columns) {
    rows[0].push_back(one_line(column.heading[0]));
    rows[1].push_back(one_line(column.heading[1]));
  }
  rows[1].emplace_back("verdict");
  for (std::size_t i = 0; i < outlets.size(); ++i) {
    rows.push_back({shortened(one_line(outlets[i]->id), kMostIdColumns)});
    for (const KeyColumn& column : columns) {
      rows.back().push_back(one_line(column.cells[i]));
    }
    rows.back().emplace_back(record::to_string(outlets[i]->verdict));
  }
  if (columns.empty()) {
    rows.erase(rows.begin());
  }
  return aligned(rows, "l" + std::string(columns.size(), 'r') + "l");
}

// With as many key figures as fit a line.
std::vector<std::string> outlet_table(const Outlets& outlets) {
  std::vector<KeyColumn> columns = key_columns(outlets, kMostTerminalColumns);
  std::vector<std::string> lines = table_of(outlets, columns);
  while (!fit(lines) && !columns.empty()) {
    columns.pop_back();
    lines = table_of(outlets, columns);
  }
  return lines;
}

std::string id_of(const record::OutletRecord& outlet, const Most& most) {
  return shortened(one_line(outlet.id), most.id_columns);
}

void add_outlets(const View& view, const Most& most, TerminalText& text) {
  const std::vector<std::size_t> rows = worst_first(view, most.outlets);
  const Outlets outlets = outlets_of(view.run, rows);
  if (rows.size() < view.outlets.size()) {
    text.add(count_table(view, most.groups));
    text.add(
        fmt::format("{} of the {} outlets, the worst first; `gsbench report RUN --outlet ID` "
                    "shows others:",
                    rows.size(), view.outlets.size()));
  }
  if (!outlets.empty()) {
    text.add(outlets, outlet_table(outlets));
  }
  if (!is_judged(view.run)) {
    for (const std::size_t index : rows) {
      text.add_named("Kept of " + id_of(view.run.outlets[index], most),
                     kept_sentence(view.run, kept_of(view, index)));
    }
  }
  const std::string doubt = doubt_note(outlets);
  if (!doubt.empty()) {
    text.add(doubt);
  }
}

// Above the shortfalls.
void add_head(const View& view, const Most& most, TerminalText& text) {
  const record::RunRecord& run = view.run;
  text.add(
      fmt::format("{}  seed {}  {}", one_line(run.profile), run.seed, one_line(run.profile_title)));
  add_outlets(view, most, text);
  if (run.recording.replaces_profile) {
    text.add(one_line(played_sentence(run)));
  }
  text.add_first(faulty_outlets(view), most.faults, " outlets", [&](const auto* outlet) {
    text.add_named(outlet->verdict, id_of(*outlet, most), one_line(outlet_sentence(*outlet)));
  });
}

void add_shortfalls(const std::vector<Shortfall>& all, std::size_t shown, const Most& most,
                    TerminalText& text) {
  text.add_first(all, shown, "", [&](const Shortfall& missed) {
    text.add_named(missed.result->verdict,
                   id_of(*missed.outlet, most) + " " + one_line(missed.result->name),
                   one_line(shortfall_text(*missed.result)));
  });
}

// Below them.
void add_tail(const record::RunRecord& run, const Most& most, TerminalText& text) {
  for (const std::string& line : source_in_short(run)) {
    text.add(one_line(line));
  }
  if (has_clocks(run)) {
    text.add_first(run.clocks, most.clocks, " clocks", [&](const record::AlignedClock& clock) {
      text.add(fmt::format("Clock of {}: {}, {}", one_line(clock.what), one_line(clock.aligned_by),
                           clock_uncertainty(clock)));
    });
  }
  constexpr std::size_t kSentenceLines = 2;
  text.add(run.verdict, ": " + one_line(verdict_sentence(run)), kSentenceLines);
}

std::string text_of(const View& view, Target target) {
  const Most& most = view.outlets.size() > kMostOutletRows ? kMostOfMany : kMostOfFew;
  TerminalText text(target, most.columns);
  TerminalText tail(target, most.columns);
  add_head(view, most, text);
  add_tail(view.run, most, tail);
  const std::vector<Shortfall> missed = shortfalls(view);
  const std::size_t free = most.lines - text.lines() - tail.lines();
  const bool all_fit = missed.size() <= std::min(most.shortfalls, free);
  add_shortfalls(missed, all_fit ? missed.size() : std::min(most.shortfalls, free - 1), most, text);
  return text.text() + tail.text();
}

}  // namespace

std::string terminal(const View& view) {
  return text_of(view, Target::kPipe);
}

std::string coloured_terminal(const View& view) {
  return text_of(view, Target::kTerminal);
}

}  // namespace gsbench::render
