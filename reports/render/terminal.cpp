#include "format.hpp"
#include "key_figures.hpp"
#include "summary.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostTerminalColumns = 7;      // of key figures
constexpr std::size_t kMostIdColumns = 40;           // longer ids are shortened in the middle
constexpr std::size_t kMostTerminalShortfalls = 10;  // the HTML report has more

std::string coloured(Verdict verdict) {
  const int code = verdict == Verdict::kPass           ? 32  // green
                   : verdict == Verdict::kInconclusive ? 33  // yellow
                   : verdict == Verdict::kFail         ? 31  // red
                                                       : 35;         // magenta
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, record::to_string(verdict));
}

// On one line, without control characters.
std::string one_line(const std::string& text) {
  std::string line = valid_text(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

// Two lines of headings, then a line for each outlet, its verdict at the end.
std::vector<std::string> table_of(const record::RunRecord& run,
                                  const std::vector<KeyColumn>& columns) {
  std::vector<std::vector<std::string>> rows = {{""}, {"outlet"}};
  for (const KeyColumn& column : columns) {
    rows[0].push_back(one_line(column.heading[0]));
    rows[1].push_back(one_line(column.heading[1]));
  }
  rows[1].emplace_back("verdict");
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    rows.push_back({shortened(one_line(run.outlets[i].id), kMostIdColumns)});
    for (const KeyColumn& column : columns) {
      rows.back().push_back(one_line(column.cells[i]));
    }
    rows.back().emplace_back(record::to_string(run.outlets[i].verdict));
  }
  if (columns.empty()) {
    rows.erase(rows.begin());
  }
  return aligned(rows, "l" + std::string(columns.size(), 'r') + "l");
}

// With as many key figures as fit a line.
std::vector<std::string> outlet_table(const record::RunRecord& run) {
  std::vector<KeyColumn> columns = key_columns(run, kMostTerminalColumns);
  std::vector<std::string> lines = table_of(run, columns);
  while (!fit(lines) && !columns.empty()) {
    columns.pop_back();
    lines = table_of(run, columns);
  }
  return lines;
}

enum class Target { kPipe, kTerminal };

class Text {
 public:
  explicit Text(Target target) : target_(target) {}

  void add(const std::string& line) {
    text_ += target_ == Target::kTerminal ? wrapped(line, kLineColumns, 4) : line;
    text_ += '\n';
  }

  void add(Verdict verdict, const std::string& rest) {
    const std::size_t at = text_.size();
    add(record::to_string(verdict) + rest);
    colour(verdict, at);
  }

  // Lines of outlet_table().
  void add(const record::RunRecord& run, const std::vector<std::string>& lines) {
    const std::size_t headings = lines.size() - run.outlets.size();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      text_ += lines[i];
      if (i >= headings) {
        const Verdict verdict = run.outlets[i - headings].verdict;
        colour(verdict, text_.size() - std::string(record::to_string(verdict)).size());
      }
      text_ += '\n';
    }
  }

  const std::string& text() const { return text_; }

 private:
  void colour(Verdict verdict, std::size_t at) {
    if (target_ == Target::kTerminal) {
      text_.replace(at, std::string(record::to_string(verdict)).size(), coloured(verdict));
    }
  }

  Target target_;
  std::string text_;
};

std::string text_of(const record::RunRecord& run, Target target) {
  Text text(target);
  text.add(
      fmt::format("{}  seed {}  {}", one_line(run.profile), run.seed, one_line(run.profile_title)));
  if (!run.outlets.empty()) {
    text.add(run, outlet_table(run));
  }
  const std::string doubt = doubt_note(run);
  if (!doubt.empty()) {
    text.add(doubt);
  }
  if (run.recording.replaces_profile) {
    text.add(one_line(played_sentence(run)));
  }
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(run);
  for (std::size_t i = 0; i < std::min(faulty.size(), kMostTerminalShortfalls); ++i) {
    text.add(faulty[i]->verdict, fmt::format(" {}: {}", one_line(faulty[i]->id),
                                             one_line(outlet_sentence(*faulty[i]))));
  }
  if (faulty.size() > kMostTerminalShortfalls) {
    text.add(fmt::format("… and {} more outlets", faulty.size() - kMostTerminalShortfalls));
  }
  const std::vector<Shortfall> missed = shortfalls(run);
  for (std::size_t i = 0; i < std::min(missed.size(), kMostTerminalShortfalls); ++i) {
    const auto& [outlet, result] = missed[i];
    text.add(result->verdict, fmt::format(" {} {}: {}", one_line(outlet->id), result->name,
                                          one_line(shortfall_text(*result))));
  }
  if (missed.size() > kMostTerminalShortfalls) {
    text.add(fmt::format("… and {} more", missed.size() - kMostTerminalShortfalls));
  }
  for (const std::string& line : source_in_short(run)) {
    text.add(one_line(line));
  }
  if (has_clocks(run)) {
    for (const record::AlignedClock& clock : run.clocks) {
      text.add(fmt::format("Clock of {}: {}, {}", one_line(clock.what), one_line(clock.aligned_by),
                           clock_uncertainty(clock)));
    }
  }
  text.add(run.verdict, ": " + one_line(verdict_sentence(run)));
  return text.text();
}

}  // namespace

std::string terminal(const record::RunRecord& run) {
  return text_of(run, Target::kPipe);
}

std::string coloured_terminal(const record::RunRecord& run) {
  return text_of(run, Target::kTerminal);
}

}  // namespace gsbench::render
