#include "terminal_text.hpp"

#include <fmt/format.h>

#include <render/layout.hpp>

namespace gsbench::render {
namespace {

using record::Verdict;

constexpr std::size_t kMostNameColumns = 80;

std::string coloured(Verdict verdict) {
  const int code = verdict == Verdict::kPass           ? 32  // green
                   : verdict == Verdict::kInconclusive ? 33  // yellow
                   : verdict == Verdict::kFail         ? 31  // red
                                                       : 35;         // magenta
  return fmt::format("\x1b[1;{}m{}\x1b[0m", code, record::to_string(verdict));
}

}  // namespace

void TerminalText::add(Verdict verdict, const std::string& rest, std::size_t most_lines) {
  const std::size_t at = text_.size();
  add_up_to(record::to_string(verdict) + rest,
            most_columns_ == kAll ? kAll : most_lines * most_columns_);
  colour(verdict, at);
}

void TerminalText::add_named(const std::string& name, const std::string& rest) {
  if (most_columns_ == kAll) {
    add(name + ": " + rest);
  } else {
    const std::string start = shortened(name, kMostNameColumns) + ": ";
    add(start + beginning(rest, most_columns_ - columns_of(start)));
  }
}

void TerminalText::add_named(Verdict verdict, const std::string& name, const std::string& rest) {
  const std::size_t at = text_.size();
  add_named(record::to_string(verdict) + (" " + name), rest);
  colour(verdict, at);
}

void TerminalText::add(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    text_ += line + '\n';
  }
}

void TerminalText::add(const Outlets& outlets, const std::vector<std::string>& lines) {
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

std::size_t TerminalText::lines() const {
  return static_cast<std::size_t>(std::count(text_.begin(), text_.end(), '\n'));
}

void TerminalText::add_up_to(const std::string& line, std::size_t columns) {
  const std::string shown = columns == kAll ? line : shortened(line, columns);
  text_ += target_ == Target::kTerminal ? wrapped(shown, kLineColumns, 4) : shown;
  text_ += '\n';
}

void TerminalText::colour(Verdict verdict, std::size_t at) {
  if (target_ == Target::kTerminal) {
    text_.replace(at, std::string(record::to_string(verdict)).size(), coloured(verdict));
  }
}

}  // namespace gsbench::render
