#include "mains.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <string_view>
#include <utility>

namespace gs::host {
namespace {

constexpr double kFullScale_pu = 1.5;

struct Cell {
  std::string_view text;
  std::size_t column = 0;  // of the line, from 1
};

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\"");
  return first == std::string_view::npos
             ? std::string_view()
             : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<Cell> cells_of(std::string_view line) {
  std::vector<Cell> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    cells.push_back({trimmed(line.substr(begin, end - begin)), begin + 1});
    begin = end + 1;
  }
  return cells;
}

std::optional<double> number_in(std::string_view text) {
  if (!text.empty() && text.front() == '+') {
    text.remove_prefix(1);
  }
  double number = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr == text.data() + text.size();
  return whole && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

// Printable, and short enough for a message.
std::string quoted(std::string_view text) {
  std::string quote = "\"";
  for (const char c : text.substr(0, 40)) {
    quote += c >= ' ' && c <= '~' ? c : '?';
  }
  return quote + '"';
}

std::string plain_figure(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

class CurveReader {
 public:
  CurveReader(std::string path, std::int32_t nominal_hz, Curve& curve, std::string& why)
      : path_(std::move(path)), nominal_hz_(nominal_hz), curve_(curve), why_(why) {}

  bool read() {
    errno = 0;
    std::ifstream file(path_, std::ios::binary);
    std::string line;
    if (file.peek() == std::ifstream::traits_type::eof() && errno != 0) {  // a folder opens
      why_ = path_ + ": cannot be read: " + std::strerror(errno);
      return false;
    }
    while (std::getline(file, line)) {
      ++line_;
      if (line_ == 1 && line.rfind("\xEF\xBB\xBF", 0) == 0) {
        line.erase(0, 3);
      }
      if (!trimmed(line).empty() && !(value_ ? read_row(line) : read_header(line))) {
        return false;
      }
    }
    return curve_.t_s.size() >= 2 || refuse(1, "needs a header and at least two rows");
  }

 private:
  bool refuse(std::size_t column, const std::string& why) {
    why_ = path_ + ':' + std::to_string(std::max<std::size_t>(line_, 1)) + ':' +
           std::to_string(column) + ": " + why;
    return false;
  }

  bool read_header(std::string_view line) {
    const std::vector<Cell> cells = cells_of(line);
    const auto find = [&](std::string_view name) -> std::optional<std::size_t> {
      for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].text == name) {
          return i;
        }
      }
      return std::nullopt;
    };
    time_ = find("t_s");
    const std::optional<std::size_t> voltage = find("voltage_pu");
    curve_.is_voltage = voltage.has_value();
    value_ = voltage ? voltage : find("frequency_hz");
    return (time_ && value_) ||
           refuse(1, "the header must name a column t_s and a column frequency_hz or voltage_pu");
  }

  std::optional<double> number(const std::vector<Cell>& cells, std::size_t place) {
    if (place >= cells.size()) {
      refuse(cells.back().column, "the row has too few cells");
      return std::nullopt;
    }
    const std::optional<double> found = number_in(cells[place].text);
    if (!found) {
      refuse(cells[place].column, quoted(cells[place].text) + " is not a number");
    }
    return found;
  }

  bool read_row(std::string_view line) {
    const std::vector<Cell> cells = cells_of(line);
    const std::optional<double> t_s = number(cells, *time_);
    const std::optional<double> value = t_s ? number(cells, *value_) : std::nullopt;
    if (!value) {
      return false;
    }
    if (curve_.t_s.empty()) {
      first_s_ = *t_s;
    } else if (*t_s - first_s_ <= curve_.t_s.back()) {
      return refuse(cells[*time_].column, "the time must be later than in the row before");
    }
    const double least = curve_.is_voltage ? -kFullScale_pu : 0.5 * nominal_hz_;
    const double most = curve_.is_voltage ? kFullScale_pu : 1.5 * nominal_hz_;
    if (*value < least || *value > most) {
      return refuse(cells[*value_].column, quoted(cells[*value_].text) + " is outside of " +
                                               plain_figure(least) + " … " + plain_figure(most) +
                                               (curve_.is_voltage ? " p.u." : " Hz"));
    }
    curve_.t_s.push_back(*t_s - first_s_);
    curve_.value.push_back(*value);
    return true;
  }

  std::string path_;
  double nominal_hz_;
  Curve& curve_;
  std::string& why_;
  std::size_t line_ = 0;
  std::optional<std::size_t> time_;
  std::optional<std::size_t> value_;
  double first_s_ = 0.0;
};

}  // namespace

bool read_curve(const std::string& path, std::int32_t nominal_hz, Curve& curve, std::string& why) {
  curve = {};
  return CurveReader(path, nominal_hz, curve, why).read();
}

}  // namespace gs::host
