#include "format.hpp"
#include "key_figures.hpp"
#include "summary.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostColumns = 7;      // beside name and verdict: fits 120 characters
constexpr std::size_t kMostShortfalls = 10;  // the report has all

// Columns of text on a terminal: code points, as nothing wider is printed here.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
  }));
}

std::string padded(const std::string& text, std::size_t columns, bool right) {
  const std::size_t have = width(text);
  const std::string pad(columns > have ? columns - have : 0, ' ');
  return right ? pad + text : text + pad;
}

std::string coloured(Verdict verdict, const std::string& text, bool colour) {
  if (!colour) return text;
  const int code = verdict == Verdict::kPass           ? 32  // green
                   : verdict == Verdict::kInconclusive ? 33  // yellow
                   : verdict == Verdict::kFail         ? 31  // red
                                                       : 35;         // magenta
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, text);
}

// One line of text whatever was in it.
std::string one_line(const std::string& text) {
  std::string line = valid_text(text);
  std::replace(line.begin(), line.end(), '\n', ' ');
  std::replace(line.begin(), line.end(), '\t', ' ');
  return line;
}

}  // namespace

std::string terminal(const record::RunRecord& run, bool colour) {
  std::vector<std::vector<std::string>> rows(1);
  rows[0].emplace_back("outlet");
  const std::vector<KeyFigure> keys = key_figures(run, kMostColumns);
  for (const KeyFigure& key : keys) rows[0].emplace_back(key.heading);
  rows[0].emplace_back("verdict");
  for (const record::OutletRecord& outlet : run.outlets) {
    std::vector<std::string> row = {one_line(outlet.id)};
    for (const KeyFigure& key : keys) row.push_back(one_line(key_text(outlet, key)));
    row.emplace_back(record::to_string(outlet.verdict));
    rows.push_back(std::move(row));
  }

  std::string out = fmt::format("{}  seed {}  {}\n", one_line(run.profile), run.seed,
                                one_line(run.profile_title));
  std::vector<std::size_t> columns(rows[0].size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) columns[i] = std::max(columns[i], width(row[i]));
  }
  for (std::size_t r = 0; r < rows.size() && rows.size() > 1; ++r) {
    for (std::size_t i = 0; i + 1 < rows[r].size(); ++i) {
      out += padded(rows[r][i], columns[i], i > 0) + "  ";
    }
    out +=
        (r == 0 ? rows[r].back() : coloured(run.outlets[r - 1].verdict, rows[r].back(), colour)) +
        '\n';
  }

  const std::string doubt = doubt_note(run);
  if (!doubt.empty()) out += doubt + '\n';
  if (run.recording.replaces_profile) out += one_line(played_sentence(run)) + '\n';
  const std::vector<const record::OutletRecord*> faulty = faulty_outlets(run);
  for (std::size_t i = 0; i < std::min(faulty.size(), kMostShortfalls); ++i) {
    out += fmt::format("{} {}: {}\n",
                       coloured(faulty[i]->verdict, record::to_string(faulty[i]->verdict), colour),
                       one_line(faulty[i]->id), one_line(outlet_sentence(*faulty[i])));
  }
  if (faulty.size() > kMostShortfalls) {
    out += fmt::format("… and {} more outlets\n", faulty.size() - kMostShortfalls);
  }
  const std::vector<Shortfall> missed = shortfalls(run);
  for (std::size_t i = 0; i < std::min(missed.size(), kMostShortfalls); ++i) {
    const auto& [outlet, result] = missed[i];
    out += fmt::format("{} {} {}: {}\n",
                       coloured(result->verdict, record::to_string(result->verdict), colour),
                       one_line(outlet->id), result->name, one_line(shortfall_text(*result)));
  }
  if (missed.size() > kMostShortfalls) {
    out += fmt::format("… and {} more\n", missed.size() - kMostShortfalls);
  }
  out += fmt::format("{}: {}\n", coloured(run.verdict, record::to_string(run.verdict), colour),
                     one_line(verdict_sentence(run)));
  return out;
}

}  // namespace gsbench::render
