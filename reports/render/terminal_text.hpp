// Lines for a terminal, in which verdicts have a colour, or for a pipe.
#pragma once

#include "key_figures.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

enum class Target { kPipe, kTerminal };

// For a terminal, lines wrap at kLineColumns.
class TerminalText {
 public:
  static constexpr std::size_t kAll = std::numeric_limits<std::size_t>::max();

  // Lines of more than `most_columns` are shortened.
  TerminalText(Target target, std::size_t most_columns)
      : target_(target), most_columns_(most_columns) {}

  void add(const std::string& line) { add_up_to(line, most_columns_); }
  // Begins with the verdict.
  void add(record::Verdict verdict, const std::string& rest, std::size_t most_lines = 1);

  // "NAME: rest", of which the name stays: the rest is shortened, at its end.
  void add_named(const std::string& name, const std::string& rest);
  void add_named(record::Verdict verdict, const std::string& name, const std::string& rest);

  void add(const std::vector<std::string>& lines);
  // A table whose last lines are those of the outlets, each with its verdict at the end.
  void add(const Outlets& outlets, const std::vector<std::string>& lines);

  // The first `most` of `all`, each by add_one, and how many more there are.
  template <class Item, class AddOne>
  void add_first(const std::vector<Item>& all, std::size_t most, const char* what,
                 const AddOne& add_one) {
    for (std::size_t i = 0; i < std::min(all.size(), most); ++i) {
      add_one(all[i]);
    }
    if (all.size() > most) {
      add("… and " + std::to_string(all.size() - most) + " more" + what);
    }
  }

  const std::string& text() const { return text_; }
  std::size_t lines() const;

 private:
  void add_up_to(const std::string& line, std::size_t columns);
  void colour(record::Verdict verdict, std::size_t at);

  Target target_;
  std::size_t most_columns_;
  std::string text_;
};

}  // namespace gsbench::render
