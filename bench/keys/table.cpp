#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include <keys/table.hpp>

namespace gsbench::keys {
namespace {

double as_number(const Value& value) {
  const auto* whole = std::get_if<std::int64_t>(&value.data);
  return whole != nullptr ? static_cast<double>(*whole) : std::get<double>(value.data);
}

}  // namespace

Table::Table(const Document& document, const Key& declared)
    : Table(document, document.root, declared, "") {
  check();
}

Table::Table(const Document& document, const Value& value, const Key& declared, std::string path)
    : document_(&document), value_(&value), declared_(&declared), path_(std::move(path)) {}

const Key& Table::declared(const std::string& key) const {
  const auto& keys = declared_->inner;
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& known) { return known.name == key; });
  if (found == keys.end()) {
    throw std::logic_error("key is not declared: " + key);
  }
  return *found;
}

const Value* Table::find(const std::string& key) const {
  (void)declared(key);
  const auto& entries = std::get<Entries>(value_->data);
  const auto found = std::find_if(entries.begin(), entries.end(),
                                  [&](const Entry& entry) { return entry.key == key; });
  return found == entries.end() ? nullptr : &found->value;
}

const Array& Table::items(const std::string& key) const {
  static const Array kNone;
  const Value* value = find(key);
  return value == nullptr ? kNone : std::get<Array>(value->data);
}

Position Table::at(const std::string& key) const {
  const Value* value = find(key);
  return value == nullptr ? value_->at : value->at;
}

std::string Table::path_of(const std::string& key) const {
  return path_.empty() ? key : path_ + "." + key;
}

std::string Table::label() const {
  return path_.empty() ? declared_->name : header_of(*declared_, path_);
}

void Table::refuse(Position at, const std::string& message) const {
  throw error_at(document_->path, at, message);
}

void Table::refuse(const std::string& key, const std::string& message) const {
  refuse(at(key), message);
}

void Table::refuse_missing(const std::string& key, const std::string& remedy) const {
  refuse(value_->at, fmt::format("missing key \"{}\" in {}; give {}", key, label(), remedy));
}

std::optional<double> Table::find_number(const std::string& key, const Range& narrower) const {
  if (const Value* value = find(key)) {
    const double number = as_number(*value);
    if (!narrower.holds(number)) {
      refuse(value->at, fmt::format("{} is {}; it must be {}", key, number, narrower.describe()));
    }
    return number;
  }
  const auto* fallback = std::get_if<double>(&declared(key).fallback);
  return fallback == nullptr ? std::nullopt : std::optional<double>(*fallback);
}

std::optional<std::int64_t> Table::find_whole(const std::string& key) const {
  if (const Value* value = find(key)) {
    return std::get<std::int64_t>(value->data);
  }
  const auto fallback = find_number(key);
  return fallback ? std::optional<std::int64_t>(static_cast<std::int64_t>(*fallback))
                  : std::nullopt;
}

std::optional<std::string> Table::find_text(const std::string& key) const {
  if (const Value* value = find(key)) {
    if (const auto* date = std::get_if<DateOrTime>(&value->data)) {
      return date->text;
    }
    return holds_number(key) ? fmt::format("{}", as_number(*value))
                             : std::get<std::string>(value->data);
  }
  const auto* fallback = std::get_if<std::string>(&declared(key).fallback);
  return fallback == nullptr ? std::nullopt : std::optional<std::string>(*fallback);
}

std::vector<double> Table::numbers(const std::string& key) const {
  std::vector<double> found;
  for (const Value& item : items(key)) {
    found.push_back(as_number(item));
  }
  return found;
}

std::vector<PlacedText> Table::texts(const std::string& key) const {
  std::vector<PlacedText> found;
  for (const Value& item : items(key)) {
    found.push_back({std::get<std::string>(item.data), item.at});
  }
  return found;
}

std::vector<Row> Table::rows(const std::string& key) const {
  std::vector<Row> found;
  for (const Value& item : items(key)) {
    Row& row = found.emplace_back();
    for (const Value& cell : std::get<Array>(item.data)) {
      row.values.push_back(as_number(cell));
      row.at.push_back(cell.at);
    }
  }
  return found;
}

bool Table::holds_number(const std::string& key) const {
  const Value* value = find(key);
  return value != nullptr && (std::holds_alternative<std::int64_t>(value->data) ||
                              std::holds_alternative<double>(value->data));
}

bool Table::holds_table(const std::string& key) const {
  const Value* value = find(key);
  return value != nullptr && std::holds_alternative<Entries>(value->data);
}

Table Table::table(const std::string& key) const {
  return {*document_, *find(key), declared(key), path_of(key)};
}

std::vector<Table> Table::tables(const std::string& key) const {
  std::vector<Table> found;
  for (const Value& item : items(key)) {
    found.push_back({*document_, item, declared(key), path_of(key)});
  }
  return found;
}

}  // namespace gsbench::keys
