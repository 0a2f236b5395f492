#include <cmath>
#include <utility>

#include <fmt/format.h>

#include <keys/key.hpp>

namespace gsbench::keys {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Key holder(Type type, std::string name, std::string meaning, std::vector<Key> inner) {
  return Key{type, std::move(name), std::move(meaning)}.with(&Key::inner, std::move(inner));
}

}  // namespace

Range above(double low) {
  return {low, kInfinity, true};
}

Range at_least(double low) {
  return {low};
}

Range between(double low, double high) {
  return {low, high};
}

bool Range::holds(double value) const {
  return std::isfinite(value) && (low_open ? value > low : value >= low) &&
         (high_open ? value < high : value <= high);
}

std::string Range::describe() const {
  std::string text;
  if (std::isfinite(low)) {
    text = fmt::format("{} {}", low_open ? "above" : "at least", low);
  }
  if (std::isfinite(high)) {
    if (!text.empty()) {
      text += " and ";
    }
    text += fmt::format("{} {}", high_open ? "below" : "at most", high);
  }
  if (text.empty()) {
    text = "a finite number";
  }
  return note.empty() ? text : fmt::format("{} ({})", text, note);
}

Key number(std::string name, std::string unit, Range range, std::string meaning) {
  return {Type::kNumber, std::move(name), std::move(meaning), std::move(unit), std::move(range)};
}

Key whole(std::string name, std::string unit, double low, double high, std::string meaning) {
  return {Type::kWhole, std::move(name), std::move(meaning), std::move(unit), between(low, high)};
}

Key text(std::string name, std::string meaning) {
  return {Type::kText, std::move(name), std::move(meaning)};
}

Key text_or_whole(std::string name, double low, double high, std::string meaning) {
  return number(std::move(name), "", between(low, high), std::move(meaning))
      .with(&Key::type, Type::kTextOrWhole);
}

Key instant(std::string name, Range range, std::string meaning) {
  return number(std::move(name), "s", std::move(range), std::move(meaning))
      .with(&Key::type, Type::kInstant);
}

Key id(std::string name, std::size_t longest, std::string meaning) {
  return Key{Type::kId, std::move(name), std::move(meaning)}.with(&Key::longest, longest);
}

Key choice(std::string name, std::vector<std::string> choices, std::string meaning) {
  return Key{Type::kChoice, std::move(name), std::move(meaning)}.with(&Key::choices,
                                                                      std::move(choices));
}

Key array(std::string name, Key item, std::string meaning) {
  item.name = "an item of " + name;
  const std::string unit = item.unit;
  return holder(Type::kArray, std::move(name), std::move(meaning), {std::move(item)})
      .with(&Key::unit, unit);
}

Key row(std::vector<Key> columns) {
  return holder(Type::kRow, "", "", std::move(columns));
}

Key table(std::string name, std::string meaning, std::vector<Key> inner) {
  return holder(Type::kTable, std::move(name), std::move(meaning), std::move(inner));
}

Key tables(std::string name, std::string meaning, std::vector<Key> inner) {
  return holder(Type::kTables, std::move(name), std::move(meaning), std::move(inner));
}

Key text_or_table(std::string name, std::string meaning, std::vector<Key> inner) {
  return holder(Type::kTextOrTable, std::move(name), std::move(meaning), std::move(inner));
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
