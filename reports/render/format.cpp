#include "format.hpp"

#include <QString>
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace gsbench::render {
namespace {

constexpr int kMostDecimals = 9;

// "-0.00" says nothing that "0.00" does not.
std::string without_negative_zero(std::string text) {
  if (text.find_first_not_of("-0.") == std::string::npos && text.front() == '-') {
    text.erase(0, 1);
  }
  return text;
}

std::string not_finite(double value) {
  if (std::isnan(value)) {
    return "–";
  }
  return value > 0.0 ? "∞" : "-∞";
}

int magnitude(double value) {
  return static_cast<int>(std::floor(std::log10(std::abs(value))));
}

int decimals_of(double uncertainty) {
  return std::clamp(1 - magnitude(uncertainty), 0, kMostDecimals);
}

// Two significant digits, never less than it is; what binary fractions add is no reason to go up.
std::string rounded_up(double uncertainty) {
  const int decimals = decimals_of(uncertainty);
  const double per_unit = std::pow(10.0, decimals);
  return fmt::format("{:.{}f}", std::ceil(uncertainty * per_unit - 1e-6) / per_unit, decimals);
}

}  // namespace

std::string figure(double value, int significant) {
  if (!std::isfinite(value)) {
    return not_finite(value);
  }
  if (value == 0.0) {
    return "0";
  }
  const int decimals = significant - 1 - magnitude(value);
  if (decimals > kMostDecimals) {
    return fmt::format("{:.{}g}", value, significant);
  }
  std::string text = fmt::format("{:.{}f}", value, std::max(decimals, 0));
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') {
      text.pop_back();
    }
  }
  return text;
}

std::string figure_within(double value, double uncertainty) {
  if (!std::isfinite(value) || !std::isfinite(uncertainty) || uncertainty <= 0.0) {
    return figure(value);
  }
  return without_negative_zero(fmt::format("{:.{}f}", value, decimals_of(uncertainty)));
}

std::string fixed(double value, int decimals) {
  if (!std::isfinite(value)) {
    return not_finite(value);
  }
  return without_negative_zero(
      fmt::format("{:.{}f}", value, std::clamp(decimals, 0, kMostDecimals)));
}

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + ' ' + unit;
}

std::string limits(const record::MeasurementResult& result) {
  if (!result.judged) {
    return "";
  }
  if (!result.expected_text.empty()) {
    return result.expected_text;
  }
  const bool has_low = !std::isnan(result.low);
  const bool has_high = !std::isnan(result.high);
  if (!has_low && !has_high) {
    return "";
  }
  const std::string low = figure(result.low, 6);
  const std::string high = figure(result.high, 6);
  if (!has_high) {
    return with_unit("≥ " + low, result.unit);
  }
  if (!has_low) {
    return with_unit("≤ " + high, result.unit);
  }
  if (result.low == result.high) {
    return with_unit("= " + low, result.unit);
  }
  return with_unit(low + " … " + high, result.unit);
}

std::string value_of(const record::MeasurementResult& result) {
  if (!result.text.empty()) {
    return result.text;
  }
  if (std::isnan(result.value)) {
    return "–";
  }
  std::string text = figure_within(result.value, result.uncertainty);
  if (std::isfinite(result.uncertainty) && result.uncertainty > 0.0) {
    text += " ± " + rounded_up(result.uncertainty);
  }
  return with_unit(text, result.unit);
}

double seconds(const record::RunRecord& run, std::int64_t tick) {
  if (run.sample_rate_hz <= 0) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return static_cast<double>(tick) / static_cast<double>(run.sample_rate_hz);
}

std::string valid_text(const std::string& text) {
  QString unicode = QString::fromUtf8(text.data(), static_cast<int>(text.size()));
  for (QChar& character : unicode) {
    const ushort code = character.unicode();
    const bool control = (code < 0x20 && code != '\t' && code != '\n') ||
                         (code >= 0x7f && code < 0xa0) || code >= 0xfffe;
    if (control) {
      character = QChar::ReplacementCharacter;
    }
  }
  return unicode.toStdString();
}

std::size_t columns_of(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) != 0x80U;
  }));
}

std::string wrapped(const std::string& text, std::size_t columns, std::size_t indent) {
  std::string lines;
  std::size_t used = 0;    // columns of the current line
  bool line_empty = true;  // but for its indent
  const auto start_line = [&] {
    lines += '\n' + std::string(indent, ' ');
    used = indent;
    line_empty = true;
  };
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    const std::string word = text.substr(begin, end - begin);
    const std::size_t width = columns_of(word);
    if (!line_empty && used + 1 + width > columns) {
      start_line();
    } else if (begin > 0 && text[begin - 1] == ' ') {
      lines += ' ';
      ++used;
    }
    lines += word;
    used += width;
    line_empty = line_empty && word.empty();
    if (end < text.size() && text[end] == '\n') {
      start_line();
    }
    begin = end + 1;
  }
  return lines;
}

std::vector<std::string> aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) {
      widths[i] = std::max(widths[i], columns_of(row[i]));
    }
  }
  std::vector<std::string> lines;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string pad(widths[i] - columns_of(row[i]), ' ');
      line += i == 0 ? row[i] + pad : "  " + pad + row[i];
    }
    lines.push_back(line);
  }
  return lines;
}

}  // namespace gsbench::render
