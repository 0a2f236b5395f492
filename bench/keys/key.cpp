#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <keys/key.hpp>

namespace gsbench::keys {
namespace {

Key declare(Type type, std::string name, std::string meaning) {
  Key key;
  key.type = type;
  key.name = std::move(name);
  key.meaning = std::move(meaning);
  return key;
}

Key with_inner(Key key, std::vector<Key> inner) {
  key.inner = std::move(inner);
  return key;
}

}  // namespace

Range above(double low) {
  Range range;
  range.low = low;
  range.low_open = true;
  return range;
}

Range at_least(double low) {
  Range range;
  range.low = low;
  return range;
}

Range between(double low, double high) {
  Range range;
  range.low = low;
  range.high = high;
  return range;
}

bool Range::holds(double value) const {
  return std::isfinite(value) && (low_open ? value > low : value >= low) &&
         (high_open ? value < high : value <= high);
}

std::string Range::describe() const {
  std::string words;
  if (std::isfinite(low)) words = fmt::format("{} {}", low_open ? "above" : "at least", low);
  if (std::isfinite(high)) {
    if (!words.empty()) words += " and ";
    words += fmt::format("{} {}", high_open ? "below" : "at most", high);
  }
  if (words.empty()) words = "a finite number";
  return note.empty() ? words : fmt::format("{} ({})", words, note);
}

bool is_identifier(const std::string& text, std::size_t longest) {
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

Key Key::require(std::string what) const {
  Key key = *this;
  key.required = true;
  key.remedy = std::move(what);
  return key;
}

Key Key::by_default(double value) const {
  Key key = *this;
  key.fallback = value;
  return key;
}

Key Key::by_default(std::string value) const {
  Key key = *this;
  key.fallback = std::move(value);
  return key;
}

Key Key::or_else(std::string words_for_documents) const {
  Key key = *this;
  key.otherwise = std::move(words_for_documents);
  return key;
}

Key Key::permits(std::string words_for_documents) const {
  Key key = *this;
  key.permitted = std::move(words_for_documents);
  return key;
}

Key Key::described_in(std::string section) const {
  Key key = *this;
  key.described_at = std::move(section);
  return key;
}

Key number(std::string name, std::string unit, Range range, std::string meaning) {
  Key key = declare(Type::kNumber, std::move(name), std::move(meaning));
  key.unit = std::move(unit);
  key.range = std::move(range);
  return key;
}

Key whole(std::string name, std::string unit, double low, double high, std::string meaning) {
  Key key = number(std::move(name), std::move(unit), between(low, high), std::move(meaning));
  key.type = Type::kWhole;
  return key;
}

Key text(std::string name, std::string meaning) {
  return declare(Type::kText, std::move(name), std::move(meaning));
}

Key id(std::string name, std::size_t longest, std::string meaning) {
  Key key = declare(Type::kId, std::move(name), std::move(meaning));
  key.longest = longest;
  return key;
}

Key word(std::string name, std::vector<std::string> words, std::string meaning) {
  Key key = declare(Type::kWord, std::move(name), std::move(meaning));
  key.words = std::move(words);
  return key;
}

Key array(std::string name, Key item, std::string meaning) {
  Key key = declare(Type::kArray, std::move(name), std::move(meaning));
  key.unit = item.unit;
  item.name = "an item of " + key.name;
  return with_inner(std::move(key), {std::move(item)});
}

Key row(std::vector<Key> columns) {
  return with_inner(declare(Type::kRow, "", ""), std::move(columns));
}

Key table(std::string name, std::string meaning, std::vector<Key> inner) {
  return with_inner(declare(Type::kTable, std::move(name), std::move(meaning)), std::move(inner));
}

Key tables(std::string name, std::string meaning, std::vector<Key> inner) {
  return with_inner(declare(Type::kTables, std::move(name), std::move(meaning)), std::move(inner));
}

Key text_or_table(std::string name, std::string meaning, std::vector<Key> inner) {
  return with_inner(declare(Type::kTextOrTable, std::move(name), std::move(meaning)),
                    std::move(inner));
}

bool is_number(const Key& key) {
  return key.type == Type::kNumber || key.type == Type::kWhole;
}

bool is_table(const Key& key) {
  return key.type == Type::kTable || key.type == Type::kTables || key.type == Type::kTextOrTable;
}

std::string header_of(const Key& table, const std::string& path) {
  return table.type == Type::kTables ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

}  // namespace gsbench::keys
