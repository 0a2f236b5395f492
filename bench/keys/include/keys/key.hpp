// What a file may say: each key is declared once, with its name, type, unit, range, default and
// meaning. From the declarations come what is read and refused (keys/table.hpp), the tables of
// profiles/README.md (markdown()) and the JSON Schema for editors (`gsbench schema`).
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace gsbench::keys {

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

enum class Type {
  kNumber,
  kWhole,  // a number without a fraction
  kText,   // never empty
  kId,     // a text that is an identifier
  kWord,   // a text, one of `words`
  kArray,  // of what `inner` declares, at least one
  kRow,    // an array of as many values as `inner` declares
  kTable,
  kTables,       // an array of tables
  kTextOrTable,  // a name, or the thing itself in place
};

using Default = std::variant<std::monostate, double, std::string>;

struct Key {
  Type type = Type::kText;
  std::string name;
  std::string meaning;
  std::string unit = {};
  Range range = {};                     // of a number, whatever else the file says
  std::size_t longest = 0;              // of an id, characters
  std::vector<std::string> words = {};  // of a word
  std::vector<Key> inner = {};  // of a table its keys, of an array its item, of a row its columns

  bool required = false;
  std::string remedy = {};  // of a required key: what to write, for messages
  Default fallback = {};    // where it is fixed
  // For documents, where type, range and fallback do not say it all.
  std::string permitted = {};
  std::string otherwise = {};     // what stands where the key is left out
  std::string described_at = {};  // the section of a table's keys, where it is another's

  // The same key with another value of that field.
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
Key id(std::string name, std::size_t longest, std::string meaning);
Key word(std::string name, std::vector<std::string> words, std::string meaning);
// `item` declares each item; what it is called in messages follows from `name`.
Key array(std::string name, Key item, std::string meaning);
Key row(std::vector<Key> columns);  // an item of an array
Key table(std::string name, std::string meaning, std::vector<Key> inner);
Key tables(std::string name, std::string meaning, std::vector<Key> inner);
Key text_or_table(std::string name, std::string meaning, std::vector<Key> inner);

bool is_number(const Key& key);
bool is_table(const Key& key);  // or an array of them, or a table in place of a text

// "[signal]", "[[outlet]]"; `path`: of the tables around it and its own name, joined by dots.
std::string header_of(const Key& table, const std::string& path);

// For profiles/README.md: a table of the keys, then a section for each table within, in the order
// of declaration.
std::string markdown(const Key& format);

}  // namespace gsbench::keys
