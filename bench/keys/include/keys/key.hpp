// Declarations of the keys of a file: each key is declared once, with its name, type, unit, range,
// default and meaning. The declarations are used to read and check files (keys/table.hpp), to
// print the tables of profiles/README.md (markdown()) and to print the JSON Schema for editors
// (`gsbench schema`).
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gsbench::keys {

// The permitted range of a number. NaN and infinities are never permitted.
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

enum class Type {
  kNumber,
  kWhole,        // a number without a fraction
  kText,         // never empty
  kId,           // a text that is an identifier
  kChoice,       // a text, one of `choices`
  kTextOrWhole,  // the range is that of the whole number
  kInstant,      // a number of seconds in the range, or date and time as text or TOML's own type
  kArray,        // at least one item, declared by `inner`
  kRow,          // an array with one value for each key of `inner`
  kTable,
  kTables,       // an array of tables
  kTextOrTable,  // a name, or the table that the name would refer to
};

using Default = std::variant<std::monostate, double, std::string>;

struct Key {
  Type type = Type::kText;
  std::string name;
  std::string meaning;
  std::string unit = {};
  Range range = {};                       // of a number, independent of other keys
  std::size_t longest = 0;                // of an id, characters
  std::vector<std::string> choices = {};  // the permitted texts of a choice
  std::vector<Key> inner = {};            // keys of a table, item of an array, columns of a row

  bool required = false;
  std::string remedy = {};  // for messages, if a required key is missing: what to write
  Default fallback = {};    // the default, if it is a fixed value
  // Texts for README and schema. They are given if type, range and fallback do not suffice.
  std::string permitted = {};     // the permitted values
  std::string otherwise = {};     // the default
  std::string described_at = {};  // of a table: the README section that documents its keys

  // A copy of the key with another value of the field.
  template <class T>
  Key with(T Key::*field, T value) const {
    Key key = *this;
    key.*field = std::move(value);
    return key;
  }
  Key require(std::string what = {}) const {
    return with(&Key::required, true).with(&Key::remedy, std::move(what));
  }
  Key by_default(double value) const { return with(&Key::fallback, Default(value)); }
  Key by_default(std::string value) const {
    return with(&Key::fallback, Default(std::move(value)));
  }
  Key or_else(std::string for_documents) const {
    return with(&Key::otherwise, std::move(for_documents));
  }
  Key permits(std::string for_documents) const {
    return with(&Key::permitted, std::move(for_documents));
  }
  Key described_in(std::string section) const {
    return with(&Key::described_at, std::move(section));
  }
};

Key number(std::string name, std::string unit, Range range, std::string meaning);
Key whole(std::string name, std::string unit, double low, double high, std::string meaning);
Key text(std::string name, std::string meaning);
Key text_or_whole(std::string name, double low, double high, std::string meaning);
Key instant(std::string name, Range range, std::string meaning);
Key id(std::string name, std::size_t longest, std::string meaning);
Key choice(std::string name, std::vector<std::string> choices, std::string meaning);
// `item` declares each item; messages call it "an item of <name>".
Key array(std::string name, Key item, std::string meaning);
Key row(std::vector<Key> columns);  // an item of an array
Key table(std::string name, std::string meaning, std::vector<Key> inner);
Key tables(std::string name, std::string meaning, std::vector<Key> inner);
Key text_or_table(std::string name, std::string meaning, std::vector<Key> inner);

bool is_number(const Key& key);
bool is_table(const Key& key);  // kTable, kTables or kTextOrTable

// The TOML header of a table: "[signal]", "[[outlet]]". `path`: the names of the enclosing tables
// and of the table, joined by dots.
std::string header_of(const Key& table, const std::string& path);

// For profiles/README.md: a table of the keys, then a section for each inner table, in the order
// of declaration.
std::string markdown(const Key& format);

}  // namespace gsbench::keys
