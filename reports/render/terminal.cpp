#include "format.hpp"
#include "key_figures.hpp"
#include "summary.hpp"

#include <algorithm>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostTerminalColumns = 7;      // beside name and verdict: fits 120 characters
constexpr std::size_t kMostTerminalShortfalls = 10;  // the report has all

std::string word_of(Verdict verdict, bool colour) {
  const char* word = record::to_string(verdict);
  if (!colour) {
    return word;
  }
  const int code = verdict == Verdict::kPass           ? 32  // green
                   : verdict == Verdict::kInconclusive ? 33  // yellow
                   : verdict == Verdict::kFail         ? 31  // red
                                                       : 35;         // magenta
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, word);
}

// One line of text whatever was in it.
std::string one_line(const std::string& text) {
  std::string line = valid_text(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

std::string outlet_table(const record::RunRecord& run, bool colour) {
  const std::vector<KeyFigure> keys = key_figures(run, kMostTerminalColumns);
  std::vector<std::vector<std::string>> rows = {{"outlet"}};
  for (const KeyFigure& key : keys) {
    rows[0].emplace_back(key.heading);
  }
  for (const record::OutletRecord& outlet : run.outlets) {
    rows.push_back({one_line(outlet.id)});
    for (const KeyFigure& key : keys) {
      rows.back().push_back(one_line(key_text(outlet, key)));
    }
  }
  const std::vector<std::string> lines = aligned(rows);
  std::string out = lines[0] + "  verdict\n";
  for (std::size_t i = 0; i < run.outlets.size(); ++i) {
    out += lines[i + 1] + "  " + word_of(run.outlets[i].verdict, colour) + '\n';
  }
  return out;
}

std::string text_of(const record::RunRecord& run, bool colour) {
  std::string out = fmt::format("{}  seed {}  {}\n", one_line(run.profile), run.seed,
                                one_line(run.profile_title));
  if (!run.outlets.empty()) {
    out += outlet_table(run, colour);
  }
  const std::string doubt = doubt_note(run);
  if (!doubt.empty()) {
    out += doubt + '\n';
  }
  if (run.recording.replaces_profile) {
    out += one_line(played_sentence(run)) + '\n';
  }
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(run);
  for (std::size_t i = 0; i < std::min(faulty.size(), kMostTerminalShortfalls); ++i) {
    out += fmt::format("{} {}: {}\n", word_of(faulty[i]->verdict, colour), one_line(faulty[i]->id),
                       one_line(outlet_sentence(*faulty[i])));
  }
  if (faulty.size() > kMostTerminalShortfalls) {
    out += fmt::format("… and {} more outlets\n", faulty.size() - kMostTerminalShortfalls);
  }
  const std::vector<Shortfall> missed = shortfalls(run);
  for (std::size_t i = 0; i < std::min(missed.size(), kMostTerminalShortfalls); ++i) {
    const auto& [outlet, result] = missed[i];
    out += fmt::format("{} {} {}: {}\n", word_of(result->verdict, colour), one_line(outlet->id),
                       result->name, one_line(shortfall_text(*result)));
  }
  if (missed.size() > kMostTerminalShortfalls) {
    out += fmt::format("… and {} more\n", missed.size() - kMostTerminalShortfalls);
  }
  out += fmt::format("{}: {}\n", word_of(run.verdict, colour), one_line(verdict_sentence(run)));
  return out;
}

}  // namespace

std::string terminal(const record::RunRecord& run) {
  return text_of(run, false);
}

std::string coloured_terminal(const record::RunRecord& run) {
  return text_of(run, true);
}

}  // namespace gsbench::render
