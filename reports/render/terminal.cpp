#include "counts.hpp"
#include "format.hpp"
#include "key_figures.hpp"
#include "summary.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostTerminalColumns = 7;  // of key figures
constexpr std::size_t kMostOutletRows = 32;      // more outlets are counted

// The most lines of each kind; the HTML report has more.
struct Most {
  std::size_t outlets;
  std::size_t groups;
  std::size_t faults;
  std::size_t shortfalls;
  std::size_t clocks;
  std::size_t columns;  // of a line; longer ones are shortened in the middle
};
constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();
constexpr Most kMostOfFew{kAll, kAll, 10, 10, kAll, kAll};
// 40 lines in all, with a line for each "… and n more", and five for notes and verdict.
constexpr Most kMostOfMany{6, 5, 3, 3, 1, kLineColumns};

std::string coloured(Verdict verdict) {
  const int code = verdict == Verdict::kPass           ? 32  // green
                   : verdict == Verdict::kInconclusive ? 33  // yellow
                   : verdict == Verdict::kFail         ? 31  // red
                                                       : 35;         // magenta
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, record::to_string(verdict));
}

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

enum class Target { kPipe, kTerminal };

class Text {
 public:
  Text(Target target, std::size_t most_columns) : target_(target), most_columns_(most_columns) {}

  void add(const std::string& line) { add_up_to(line, most_columns_); }

  void add(Verdict verdict, const std::string& rest, std::size_t most_lines = 1) {
    const std::size_t at = text_.size();
    add_up_to(record::to_string(verdict) + rest,
              most_columns_ == kAll ? kAll : most_lines * most_columns_);
    colour(verdict, at);
  }

  void add(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      text_ += line + '\n';
    }
  }

  // Lines of outlet_table().
  void add(const Outlets& outlets, const std::vector<std::string>& lines) {
    const std::size_t headings = lines.size() - outlets.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text_ += lines[i];
      if (i >= headings) {
        const Verdict verdict = outlets[i - headings]->verdict;
        colour(verdict, text_.size() - std::string(record::to_string(verdict)).size());
      }
      text_ += '\n';
    }
  }

  // The first `most` of `all`, each by add_one, and how many more there are.
  template <class Item, class AddOne>
  void add_first(const std::vector<Item>& all, std::size_t most, const char* what,
                 const AddOne& add_one) {
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
      add_one(all[i]);
    }
    if (all.size() > most) {
      add(fmt::format("… and {} more{}", all.size() - most, what));
    }
  }

  const std::string& text() const { return text_; }

 private:
  void add_up_to(const std::string& line, std::size_t columns) {
    const std::string shown = columns == kAll ? line : shortened(line, columns);
    text_ += target_ == Target::kTerminal ? wrapped(shown, kLineColumns, 4) : shown;
    text_ += '\n';
  }

  void colour(Verdict verdict, std::size_t at) {
    if (target_ == Target::kTerminal) {
      text_.replace(at, std::string(record::to_string(verdict)).size(), coloured(verdict));
    }
  }

  Target target_;
  std::size_t most_columns_;
  std::string text_;
};

void add_outlets(const View& view, const Most& most, Text& text) {
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
  const std::string doubt = doubt_note(outlets);
  if (!doubt.empty()) {
    text.add(doubt);
  }
}

std::string text_of(const View& view, Target target) {
  const record::RunRecord& run = view.run;
  const Most& most = view.outlets.size() > kMostOutletRows ? kMostOfMany : kMostOfFew;
  Text text(target, most.columns);
  text.add(
      fmt::format("{}  seed {}  {}", one_line(run.profile), run.seed, one_line(run.profile_title)));
  add_outlets(view, most, text);
  if (run.recording.replaces_profile) {
    text.add(one_line(played_sentence(run)));
  }
  text.add_first(faulty_outlets(view), most.faults, " outlets", [&](const auto* outlet) {
    text.add(outlet->verdict,
             fmt::format(" {}: {}", one_line(outlet->id), one_line(outlet_sentence(*outlet))));
  });
  text.add_first(shortfalls(view), most.shortfalls, "", [&](const Shortfall& missed) {
    text.add(missed.result->verdict,
             fmt::format(" {} {}: {}", one_line(missed.outlet->id), missed.result->name,
                         one_line(shortfall_text(*missed.result))));
  });
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
  return text.text();
}

}  // namespace

std::string terminal(const View& view) {
  return text_of(view, Target::kPipe);
}

std::string coloured_terminal(const View& view) {
  return text_of(view, Target::kTerminal);
}

}  // namespace gsbench::render
