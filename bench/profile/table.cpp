#include "table.hpp"

#include "nearest.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace gsbench::profile {
namespace {

std::optional<double> as_number(const Value& value) {
  if (const auto* real = std::get_if<double>(&value.data)) return *real;
  if (const auto* integer = std::get_if<std::int64_t>(&value.data)) {
    return static_cast<double>(*integer);
  }
  return std::nullopt;
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

Range within_run(double duration_s) {
  Range range = between(0.0, duration_s);
  range.high_open = true;
  range.note = "the run's duration";
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

Table::Table(const Document& document, const Value& value, std::string label,
             std::initializer_list<const char*> keys)
    : document_(&document), value_(&value), label_(std::move(label)) {
  const auto* entries = std::get_if<Entries>(&value.data);
  if (entries == nullptr) {
    refuse(value.at, fmt::format("{} must be a table, not {}", label_, profile::describe(value)));
  }
  const std::vector<std::string> known(keys.begin(), keys.end());
  for (const Entry& entry : *entries) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      refuse(entry.at, fmt::format("unknown key \"{}\" in {}{}", entry.key, label_,
                                   suggestion(entry.key, known, "its keys")));
    }
  }
}

const Value* Table::find(const std::string& key) const {
  const auto& entries = std::get<Entries>(value_->data);
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

Position Table::at(const std::string& key) const {
  const Value* value = find(key);
  return value == nullptr ? value_->at : value->at;
}

void Table::refuse(Position at, const std::string& message) const {
  throw error_at(document_->path, at, message);
}

void Table::refuse(const std::string& key, const std::string& message) const {
  refuse(at(key), message);
}

void Table::refuse_missing(const std::string& key, const std::string& what) const {
  refuse(value_->at, fmt::format("{} lacks \"{}\": {}", label_, key, what));
}

double Table::checked_number(const Value& value, const std::string& name,
                             const Range& range) const {
  const std::optional<double> number = as_number(value);
  if (!number && std::holds_alternative<std::string>(value.data)) {
    refuse(value.at, fmt::format("{} is {}; it must be a plain number, in the unit that its name "
                                 "says",
                                 name, profile::describe(value)));
  }
  if (!number) {
    refuse(value.at, fmt::format("{} is {}; it must be a number", name, profile::describe(value)));
  }
  if (!range.holds(*number)) {
    refuse(value.at, fmt::format("{} is {}; it must be {}", name, *number, range.describe()));
  }
  return *number;
}

std::optional<double> Table::number(const std::string& key, const Range& range) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  return checked_number(*value, key, range);
}

double Table::required_number(const std::string& key, const Range& range) const {
  const auto value = number(key, range);
  if (!value) refuse_missing(key, "a number must be given: " + range.describe());
  return *value;
}

std::optional<std::int64_t> Table::integer(const std::string& key, std::int64_t low,
                                           std::int64_t high) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* integer = std::get_if<std::int64_t>(&value->data);
  if (integer == nullptr || *integer < low || *integer > high) {
    refuse(value->at, fmt::format("{} is {}; it must be a whole number from {} to {}", key,
                                  profile::describe(*value), low, high));
  }
  return *integer;
}

std::optional<std::string> Table::text(const std::string& key) const {
  const Value* value = find(key);
  if (value == nullptr) return std::nullopt;
  const auto* text = std::get_if<std::string>(&value->data);
  if (text == nullptr) {
    refuse(value->at,
           fmt::format("{} is {}; it must be a text in quotes", key, profile::describe(*value)));
  }
  if (text->empty()) refuse(value->at, fmt::format("{} is an empty text", key));
  return *text;
}

std::string Table::required_text(const std::string& key) const {
  auto value = text(key);
  if (!value) refuse_missing(key, "a text in quotes");
  return std::move(*value);
}

bool is_identifier(const std::string& text, std::size_t longest) {
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

std::optional<std::string> Table::identifier(const std::string& key, std::size_t longest) const {
  auto name = text(key);
  if (!name) return name;
  if (!is_identifier(*name, longest)) {
    refuse(key, fmt::format("{} is \"{}\"; it must be of letters, digits, '-', '_' and '.', at "
                            "most {} of them",
                            key, *name, longest));
  }
  return name;
}

std::optional<std::string> Table::choice(const std::string& key,
                                         const std::vector<std::string>& words) const {
  auto value = text(key);
  if (value && std::find(words.begin(), words.end(), *value) == words.end()) {
    refuse(key,
           fmt::format("{} is \"{}\"{}", key, *value, suggestion(*value, words, "what it can be")));
  }
  return value;
}

const Array& Table::checked_array(const Value& value, const std::string& key,
                                  const std::string& of_what) const {
  const auto* array = std::get_if<Array>(&value.data);
  if (array == nullptr) {
    refuse(value.at, fmt::format("{} is {}; it must be an array of {}", key,
                                 profile::describe(value), of_what));
  }
  if (array->empty()) {
    refuse(value.at,
           fmt::format("{} is empty; leave it out, or give an array of {}", key, of_what));
  }
  return *array;
}

std::vector<double> Table::numbers(const std::string& key) const {
  std::vector<double> found;
  if (const Value* value = find(key)) {
    for (const Value& item : checked_array(*value, key, "numbers")) {
      found.push_back(checked_number(item, key, {}));
    }
  }
  return found;
}

std::vector<Word> Table::words(const std::string& key) const {
  std::vector<Word> found;
  if (const Value* value = find(key)) {
    for (const Value& item : checked_array(*value, key, "texts")) {
      const auto* text = std::get_if<std::string>(&item.data);
      if (text == nullptr) {
        refuse(item.at, fmt::format("{} holds {}; it must hold texts in quotes", key,
                                    profile::describe(item)));
      }
      found.push_back({*text, item.at});
    }
  }
  return found;
}

std::vector<Row> Table::rows(const std::string& key,
                             const std::vector<std::string>& columns) const {
  std::vector<Row> found;
  const Value* value = find(key);
  if (value == nullptr) return found;
  const std::string shape = fmt::format("[{}]", fmt::join(columns, ", "));
  for (const Value& item : checked_array(*value, key, shape)) {
    const auto* cells = std::get_if<Array>(&item.data);
    if (cells == nullptr || cells->size() != columns.size()) {
      refuse(item.at,
             fmt::format("{} holds {}; each of its items must be {}", key,
                         cells == nullptr ? profile::describe(item)
                                          : fmt::format("an array of {} values", cells->size()),
                         shape));
    }
    Row row;
    for (std::size_t i = 0; i < columns.size(); ++i) {
      row.values.push_back(checked_number((*cells)[i], columns[i], {}));
      row.at.push_back((*cells)[i].at);
    }
    found.push_back(std::move(row));
  }
  return found;
}

std::vector<const Value*> Table::tables(const std::string& key) const {
  std::vector<const Value*> found;
  if (const Value* value = find(key)) {
    for (const Value& item : checked_array(*value, key, "tables")) found.push_back(&item);
  }
  return found;
}

}  // namespace gsbench::profile
