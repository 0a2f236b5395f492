#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include <keys/key.hpp>

namespace gsbench::keys {
namespace {

constexpr const char* kHead = "| key | unit | range | default | meaning |\n|---|---|---|---|---|\n";

// "0.05", "8000"; powers of ten from 10⁴ up and below 10⁻³ as "10⁷".
std::string figure(double value) {
  static const std::array<const char*, 10> kDigits = {"⁰", "¹", "²", "³", "⁴",
                                                      "⁵", "⁶", "⁷", "⁸", "⁹"};
  const std::string scientific = fmt::format("{:.9e}", value);
  const int exponent = std::stoi(scientific.substr(scientific.find('e') + 1));
  const bool power_of_ten = scientific.rfind("1.000000000e", 0) == 0;
  if (power_of_ten && (exponent >= 4 || exponent < -3) && std::abs(exponent) < 10) {
    return fmt::format("10{}{}", exponent < 0 ? "⁻" : "",
                       kDigits[static_cast<std::size_t>(std::abs(exponent))]);
  }
  return value == std::floor(value) ? fmt::format("{:.0f}", value) : fmt::format("{}", value);
}

std::string range_text(const Range& range) {
  const bool low = std::isfinite(range.low);
  const bool high = std::isfinite(range.high);
  if (low && high && range.low == -range.high) {
    return "± " + figure(range.high);
  }
  if (low && high && !range.low_open && !range.high_open) {
    return figure(range.low) + " … " + figure(range.high);
  }
  std::string text;
  if (low) {
    text = (range.low_open ? "above " : "from ") + figure(range.low);
  }
  if (low && high) {
    text += ", ";
  }
  if (high) {
    text += (range.high_open ? "below " : "at most ") + figure(range.high);
  }
  return text;
}

std::string permitted(const Key& key) {
  if (!key.permitted.empty()) {
    return key.permitted;
  }
  switch (key.type) {
    case Type::kNumber:
    case Type::kWhole:
      return range_text(key.range);
    case Type::kText:
      return "text";
    case Type::kTextOrWhole:
      return "text, or " + range_text(key.range);
    case Type::kInstant:
      return range_text(key.range) + ", or date and time";
    case Type::kId:
      return fmt::format("letters, digits, `-`, `_`, `.`; at most {}", key.longest);
    case Type::kChoice:
      return fmt::format("`{}`", fmt::join(key.choices, "`, `"));
    case Type::kArray: {
      const std::string item = permitted(key.inner.front());
      return item.front() == '`' ? fmt::format("`[{}, …]`", item.substr(1, item.size() - 2))
                                 : "array" + (item.empty() ? "" : ", each " + item);
    }
    case Type::kRow: {
      std::string columns;
      for (const Key& column : key.inner) {
        columns += (columns.empty() ? "" : ", ") + column.name;
      }
      return "`[" + columns + "]`";
    }
    case Type::kTextOrTable:
      return "text or table";
    case Type::kTable:
    case Type::kTables:
      return key.type == Type::kTable ? "table" : "tables";
  }
  return "";
}

std::string default_of(const Key& key) {
  if (key.required) {
    return "required";
  }
  if (!key.otherwise.empty()) {
    return key.otherwise;
  }
  if (const auto* number = std::get_if<double>(&key.fallback)) {
    return figure(*number);
  }
  if (const auto* text = std::get_if<std::string>(&key.fallback)) {
    return "`" + *text + "`";
  }
  return "none";
}

bool has_section(const Key& key) {
  return is_table(key) && key.described_at.empty();
}

void print(const Key& table, const std::string& path, std::string& out) {
  bool first = true;
  for (const Key& key : table.inner) {
    if (has_section(key)) {
      continue;
    }
    if (first) {
      out += kHead;
    }
    first = false;
    out += fmt::format("| `{}` |", key.name);
    for (const std::string& cell : {key.unit, permitted(key), default_of(key), key.meaning}) {
      out += (cell.empty() ? "" : " " + cell) + " |";
    }
    out += '\n';
  }
  for (const Key& key : table.inner) {
    if (!has_section(key)) {
      continue;
    }
    const std::string inner = path.empty() ? key.name : path + "." + key.name;
    out += fmt::format("\n### `{}`\n\n{}\n\n", header_of(key, inner), key.meaning);
    print(key, inner, out);
  }
}

}  // namespace

std::string markdown(const Key& format) {
  std::string out;
  print(format, "", out);
  return out;
}

}  // namespace gsbench::keys
