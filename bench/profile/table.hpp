// Typed and checked access to one table of a TOML document. Whatever it refuses it refuses with
// the place in the file and with what would be right.
#pragma once

#include "document.hpp"

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace gsbench::profile {

// What is permitted of a number. NaN and infinities never are.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   // low itself is not permitted
  bool high_open = false;  // high itself is not permitted
  std::string note = {};   // where the limit comes from, for messages

  bool holds(double value) const;
  std::string describe() const;  // "above 0 and at most 100"
};

Range above(double low);
Range at_least(double low);
Range between(double low, double high);
// An instant of a run of this length.
Range within_run(double duration_s);

// One row of an array of arrays: [[1.0, 2.0], [3.0, 4.0]].
struct Row {
  std::vector<double> values;
  std::vector<Position> at;  // of each value
};

struct Word {
  std::string text;
  Position at;
};

// An id as outlets and brokers take it: letters, digits, '-', '_', '.'.
bool is_identifier(const std::string& text, std::size_t longest);

class Table {
 public:
  // `keys` are all that the table may hold: any other is refused at once. `label` names the table
  // in messages: "[signal]". Both the document and the value must outlive the Table.
  Table(const Document& document, const Value& value, std::string label,
        std::initializer_list<const char*> keys);

  bool has(const std::string& key) const { return find(key) != nullptr; }
  // Where the key's value stands; where the table begins, if it lacks the key.
  Position at(const std::string& key) const;
  Position at() const { return value_->at; }
  const Document& document() const { return *document_; }

  std::optional<double> number(const std::string& key, const Range& range = {}) const;
  double required_number(const std::string& key, const Range& range = {}) const;
  std::optional<std::int64_t> integer(const std::string& key, std::int64_t low,
                                      std::int64_t high) const;
  std::optional<std::string> text(const std::string& key) const;  // never empty
  std::string required_text(const std::string& key) const;
  // Of letters, digits, '-', '_' and '.': ids and groups stand in file names, topics and JSON.
  std::optional<std::string> identifier(const std::string& key, std::size_t longest) const;
  // Of these words, one.
  std::optional<std::string> choice(const std::string& key,
                                    const std::vector<std::string>& words) const;

  // Empty where the table lacks the key; an array that is there must hold something.
  std::vector<double> numbers(const std::string& key) const;
  std::vector<Word> words(const std::string& key) const;
  // `columns` names what each row must hold, for messages: {"t_s", "hz"}.
  std::vector<Row> rows(const std::string& key, const std::vector<std::string>& columns) const;

  // [key] and [[key]] within this table, to be opened as Tables in their turn; null or empty where
  // there is none.
  const Value* table(const std::string& key) const { return find(key); }
  std::vector<const Value*> tables(const std::string& key) const;

  [[noreturn]] void refuse(Position at, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;
  // A key that must be there and is not; `what` says what it is for.
  [[noreturn]] void refuse_missing(const std::string& key, const std::string& what) const;

 private:
  const Value* find(const std::string& key) const;
  double checked_number(const Value& value, const std::string& name, const Range& range) const;
  const Array& checked_array(const Value& value, const std::string& key,
                             const std::string& of_what) const;

  const Document* document_;
  const Value* value_;
  std::string label_;
};

}  // namespace gsbench::profile
