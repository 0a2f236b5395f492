// Reading a document by its declared keys. All that the declarations say of the whole document is
// checked when it is opened: unknown and missing keys, types, ranges. The rest, where one value
// depends on another, is left to the reader.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <keys/document.hpp>
#include <keys/key.hpp>

namespace gsbench::keys {

// One row of an array of arrays: [[1.0, 2.0], [3.0, 4.0]].
struct Row {
  std::vector<double> values;
  std::vector<Position> at;  // of each value
};

struct Word {
  std::string text;
  Position at;
};

// One table of a document. The document and the declaration must outlive it. Asked for a key that
// is not declared, or not of the type, it throws std::logic_error.
class Table {
 public:
  // The whole document. `declared.name` is what messages call it: "a profile". Throws
  // ConfigurationError with the first place that is not as declared.
  Table(const Document& document, const Key& declared);

  bool has(const std::string& key) const { return find(key) != nullptr; }
  // Where the key's value is; where the table begins, if it lacks the key.
  Position at(const std::string& key) const;
  Position at() const { return value_->at; }
  const Document& document() const { return *document_; }

  // The value, or the declared default; none where there is neither. `narrower`: what the rest of
  // the document leaves of the declared range.
  std::optional<double> find_number(const std::string& key, const Range& narrower = {}) const;
  std::optional<std::int64_t> find_whole(const std::string& key) const;
  std::optional<std::string> find_text(const std::string& key) const;  // an id or a word, too
  // The same of keys that are required or have a default.
  double number(const std::string& key, const Range& narrower = {}) const {
    return find_number(key, narrower).value();
  }
  std::int64_t whole(const std::string& key) const { return find_whole(key).value(); }
  std::string text(const std::string& key) const { return find_text(key).value(); }

  // Of arrays; empty where the table lacks the key.
  std::vector<double> numbers(const std::string& key) const;
  std::vector<Word> words(const std::string& key) const;
  std::vector<Row> rows(const std::string& key) const;

  bool holds_table(const std::string& key) const;           // there, and not a text in its place
  Table table(const std::string& key) const;                // that is there
  std::vector<Table> tables(const std::string& key) const;  // empty where there is none

  // Throw ConfigurationError.
  [[noreturn]] void refuse(Position at, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;
  // A key that must be there and is not; `what` says what it is for.
  [[noreturn]] void refuse_missing(const std::string& key, const std::string& what) const;

 private:
  Table(const Document& document, const Value& value, const Key& declared, std::string path);

  const Key& declared(const std::string& key) const;
  const Value* find(const std::string& key) const;
  const Array& items(const std::string& key) const;
  std::string path_of(const std::string& key) const;
  std::string label() const;  // for messages
  void check() const;
  void check(const Key& key, const Value& value) const;
  [[noreturn]] void refuse_type(const Key& key, const Value& value) const;
  void check_number(const Key& key, const Value& value) const;
  void check_text(const Key& key, const Value& value) const;
  void check_items(const Key& key, const Value& value) const;

  const Document* document_;
  const Value* value_;
  const Key* declared_;
  std::string path_;  // "grid.plant"; empty: the document
};

}  // namespace gsbench::keys
