// Checks of a document that need the declarations only.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <keys/table.hpp>

namespace gsbench::keys {
namespace {

// Outlets and brokers accept these characters in an id: letters, digits, '-', '_', '.'.
bool is_identifier(const std::string& text, std::size_t longest) {
  return !text.empty() && text.size() <= longest &&
         std::all_of(text.begin(), text.end(), [](char c) {
           return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                  c == '-' || c == '_' || c == '.';
         });
}

std::string wanted(const Key& key);

std::string plural(const Key& item) {
  if (item.type == Type::kRow) {
    return wanted(item);
  }
  return is_number(item) ? "numbers" : "texts in quotes";
}

// "a whole number from 1 to 50", "[order, pct, deg]": what a key must be.
std::string wanted(const Key& key) {
  std::vector<std::string> names;
  for (const Key& inner : key.inner) {
    names.push_back(inner.name);
  }
  switch (key.type) {
    case Type::kNumber:
      return "a number";
    case Type::kWhole:
      return fmt::format("a whole number from {:.0f} to {:.0f}", key.range.low, key.range.high);
    case Type::kText:
    case Type::kId:
    case Type::kChoice:
    case Type::kTextOrTable:
      return "a text in quotes";
    case Type::kTextOrWhole:
      return "a text in quotes or a whole number";
    case Type::kInstant:
      return "a number of seconds, or date and time";
    case Type::kArray:
      return "an array of " + plural(key.inner.front());
    case Type::kRow:
      return fmt::format("[{}]", fmt::join(names, ", "));
    case Type::kTable:
      return "a table";
    case Type::kTables:
      return "an array of tables";
  }
  return "";
}

std::string remedy(const Key& key) {
  if (!key.remedy.empty()) {
    return key.remedy;
  }
  return key.type == Type::kNumber ? "a number, " + key.range.describe() : wanted(key);
}

}  // namespace

void Table::check() const {
  std::vector<std::string> known;
  for (const Key& key : declared_->inner) {
    known.push_back(key.name);
  }
  const auto* entries = std::get_if<Entries>(&value_->data);
  if (entries == nullptr) {
    refuse(value_->at, fmt::format("{} must be a table, not {}", label(), describe(*value_)));
  }
  for (const Entry& entry : *entries) {
    if (std::find(known.begin(), known.end(), entry.key) == known.end()) {
      refuse(entry.at, fmt::format("unknown key \"{}\" in {}{}", entry.key, label(),
                                   suggestion(entry.key, known, "valid keys")));
    }
  }
  for (const Key& key : declared_->inner) {
    const Value* value = find(key.name);
    if (value != nullptr) {
      check(key, *value);
    }
    if (value == nullptr && key.required) {
      refuse_missing(key.name, remedy(key));
    }
  }
}

void Table::check(const Key& key, const Value& value) const {
  switch (key.type) {
    case Type::kNumber:
    case Type::kWhole:
      return check_number(key, value);
    case Type::kTextOrWhole:
    case Type::kInstant:
      return check_alternative(key, value);
    case Type::kTextOrTable:
      if (!std::holds_alternative<Entries>(value.data)) {
        return check_text(key, value);
      }
      [[fallthrough]];
    case Type::kTable:
      return Table(*document_, value, key, path_of(key.name)).check();
    case Type::kText:
    case Type::kId:
    case Type::kChoice:
      return check_text(key, value);
    case Type::kArray:
    case Type::kRow:
    case Type::kTables:
      return check_items(key, value);
  }
}

void Table::refuse_type(const Key& key, const Value& value) const {
  refuse(value.at, fmt::format("{} is {}; it must be {}", key.name, describe(value), wanted(key)));
}

void Table::check_number(const Key& key, const Value& value) const {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  const auto* real = std::get_if<double>(&value.data);
  if (key.type == Type::kWhole) {
    if (whole != nullptr && *whole >= static_cast<std::int64_t>(key.range.low) &&
        *whole <= static_cast<std::int64_t>(key.range.high)) {
      return;
    }
  } else if (whole != nullptr || real != nullptr) {
    const double number = whole != nullptr ? static_cast<double>(*whole) : *real;
    if (key.range.holds(number)) {
      return;
    }
    refuse(value.at, fmt::format("{} is {}; it must be {}{}", key.name, number,
                                 std::isfinite(number) ? "" : "finite, ", key.range.describe()));
  } else if (std::holds_alternative<std::string>(value.data)) {
    refuse(value.at, fmt::format("{} is {}; it must be a number, without quotes and unit", key.name,
                                 describe(value)));
  }
  refuse_type(key, value);
}

// Of a key whose value is a number or something else.
void Table::check_alternative(const Key& key, const Value& value) const {
  const bool real = std::holds_alternative<double>(value.data);
  if (std::holds_alternative<std::int64_t>(value.data) || (real && key.type == Type::kInstant)) {
    return check_number(key, value);
  }
  if (std::holds_alternative<DateOrTime>(value.data) && key.type == Type::kInstant) {
    return;
  }
  check_text(key, value);
}

void Table::check_text(const Key& key, const Value& value) const {
  const auto* text = std::get_if<std::string>(&value.data);
  if (text == nullptr) {
    refuse_type(key, value);
  }
  if (text->empty()) {
    refuse(value.at, fmt::format("{} is an empty text; it must not be empty", key.name));
  }
  if (key.type == Type::kId && !is_identifier(*text, key.longest)) {
    refuse(value.at, fmt::format("{} is \"{}\"; it must consist of 1 to {} letters, digits, '-', "
                                 "'_' and '.'",
                                 key.name, *text, key.longest));
  }
  if (key.type == Type::kChoice &&
      std::find(key.choices.begin(), key.choices.end(), *text) == key.choices.end()) {
    refuse(value.at, fmt::format("{} is \"{}\"{}", key.name, *text,
                                 suggestion(*text, key.choices, "valid values")));
  }
}

void Table::check_items(const Key& key, const Value& value) const {
  const auto* items = std::get_if<Array>(&value.data);
  if (items == nullptr) {
    refuse_type(key, value);
  }
  if (key.type == Type::kRow && items->size() != key.inner.size()) {
    refuse(value.at, fmt::format("{} is an array of {} values; it must be {}", key.name,
                                 items->size(), wanted(key)));
  }
  if (items->empty()) {
    refuse(value.at, fmt::format("{} is empty; omit it, or give {}", key.name, wanted(key)));
  }
  for (std::size_t i = 0; i < items->size(); ++i) {
    const Value& item = (*items)[i];
    if (key.type == Type::kTables) {
      Table(*document_, item, key, path_of(key.name)).check();
    } else {
      check(key.type == Type::kRow ? key.inner[i] : key.inner.front(), item);
    }
  }
}

}  // namespace gsbench::keys
