// Reads a document according to its declared keys. Opening a document checks it against
// the declaration: unknown and missing keys, types, ranges. Limits that depend on other values are
// checked by the caller.
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

struct PlacedText {
  std::string text;
  Position at;
};

// One table of a document. The document and the declaration must outlive the Table. Asking for an
// undeclared key throws std::logic_error.
class Table {
 public:
  // The whole document. `declared.name` is its name in messages: "a profile". Throws
  // ConfigurationError for the first violation of the declaration.
  Table(const Document& document, const Key& declared);

  bool has(const std::string& key) const { return find(key) != nullptr; }
  // Position of the key's value, or of the table's start if the key is missing.
  Position at(const std::string& key) const;
  Position at() const { return value_->at; }
  const Document& document() const { return *document_; }

  // The value, or the declared default; nullopt if there is neither. `narrower`: an additional
  // range, which depends on the rest of the document. A value outside it throws ConfigurationError.
  std::optional<double> find_number(const std::string& key, const Range& narrower = {}) const;
  std::optional<std::int64_t> find_whole(const std::string& key) const;
  // Also of kId and kChoice; of kTextOrWhole and kInstant, a number as its shortest text.
  std::optional<std::string> find_text(const std::string& key) const;
  // The same for keys that are required or have a default.
  double number(const std::string& key, const Range& narrower = {}) const {
    return find_number(key, narrower).value();
  }
  std::int64_t whole(const std::string& key) const { return find_whole(key).value(); }
  std::string text(const std::string& key) const { return find_text(key).value(); }

  // Items of an array; empty if the key is missing.
  std::vector<double> numbers(const std::string& key) const;
  std::vector<PlacedText> texts(const std::string& key) const;
  std::vector<Row> rows(const std::string& key) const;

  bool holds_number(const std::string& key) const;          // false if the value is a text
  bool holds_table(const std::string& key) const;           // false if the value is a text
  Table table(const std::string& key) const;                // the key must be present
  std::vector<Table> tables(const std::string& key) const;  // empty if the key is missing

  // Throw ConfigurationError.
  [[noreturn]] void refuse(Position at, const std::string& message) const;
  [[noreturn]] void refuse(const std::string& key, const std::string& message) const;
  // For a missing key; `remedy`: what to write.
  [[noreturn]] void refuse_missing(const std::string& key, const std::string& remedy) const;

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
  void check_alternative(const Key& key, const Value& value) const;
  void check_text(const Key& key, const Value& value) const;
  void check_items(const Key& key, const Value& value) const;

  const Document* document_;
  const Value* value_;
  const Key* declared_;
  std::string path_;  // "grid.plant"; empty for the document
};

}  // namespace gsbench::keys
