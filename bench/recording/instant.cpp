#include "instant.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <ctime>
#include <string>

namespace gsbench::recording {
namespace {

// Parses a text from the left; after the first error good_ stays false.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : rest_(text) {}

  int digits(std::size_t count) {
    int value = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const char c = take();
      good_ = good_ && c >= '0' && c <= '9';
      value = 10 * value + (c - '0');
    }
    return value;
  }

  void expect(char wanted) {
    if (take() != wanted) {
      good_ = false;
    }
  }

  bool accept(char wanted) {
    if (rest_.empty() || rest_.front() != wanted) {
      return false;
    }
    rest_.remove_prefix(1);
    return true;
  }

  // Jan … Dec, upper or lower case, as 1 … 12.
  int month_name() {
    constexpr std::array<std::string_view, 12> kNames = {"jan", "feb", "mar", "apr", "may", "jun",
                                                         "jul", "aug", "sep", "oct", "nov", "dec"};
    std::string name;
    for (int i = 0; i < 3; ++i) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(take())));
    }
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (name == kNames[i]) {
        return static_cast<int>(i) + 1;
      }
    }
    good_ = false;
    return 0;
  }

  // ".5" as 0.5; without a point 0.
  double fraction() {
    if (rest_.empty() || rest_.front() != '.') {
      return 0.0;
    }
    std::size_t length = 1;
    while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') {
      ++length;
    }
    const std::optional<double> value = parse_number(rest_.substr(0, length));
    rest_.remove_prefix(length);
    good_ = good_ && length > 1 && value.has_value();
    return value.value_or(0.0);
  }

  bool good_and_done() const { return good_ && rest_.empty(); }

 private:
  char take() {
    if (rest_.empty()) {
      good_ = false;
      return '\0';
    }
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  std::string_view rest_;
  bool good_ = true;
};

std::optional<Instant> parse_date_and_time(std::string_view text) {
  Scanner scanner(text);
  std::tm time{};
  const bool day_first = text.size() > 2 && text[2] == '-';
  if (day_first) {
    time.tm_mday = scanner.digits(2);
    scanner.expect('-');
    time.tm_mon = scanner.month_name() - 1;
    scanner.expect('-');
    time.tm_year = scanner.digits(4) - 1900;
  } else {
    time.tm_year = scanner.digits(4) - 1900;
    scanner.expect('-');
    time.tm_mon = scanner.digits(2) - 1;
    scanner.expect('-');
    time.tm_mday = scanner.digits(2);
  }
  if (!scanner.accept('T')) {
    scanner.expect(' ');
  }
  time.tm_hour = scanner.digits(2);
  scanner.expect(':');
  time.tm_min = scanner.digits(2);
  scanner.expect(':');
  time.tm_sec = scanner.digits(2);

  Instant instant;
  instant.fraction_s = scanner.fraction();

  instant.kind = Instant::Kind::kZoned;
  int offset_minutes = 0;
  const bool east = scanner.accept('+');
  if (east || scanner.accept('-')) {
    const int hours = scanner.digits(2);
    scanner.accept(':');
    offset_minutes = (east ? 1 : -1) * (60 * hours + scanner.digits(2));
  } else if (!scanner.accept('Z')) {
    instant.kind = Instant::Kind::kLocal;
  }

  if (!scanner.good_and_done()) {
    return std::nullopt;
  }
  // timegm() changes a date that does not exist, such as 30 February, to one that does.
  std::tm real = time;
  instant.offset_s = 60 * offset_minutes;
  instant.whole_s = timegm(&real) - instant.offset_s;
  const bool exists = real.tm_mon == time.tm_mon && real.tm_mday == time.tm_mday &&
                      real.tm_hour == time.tm_hour && real.tm_min == time.tm_min &&
                      real.tm_sec == time.tm_sec;
  if (!exists) {
    return std::nullopt;
  }
  return instant;
}

}  // namespace

std::optional<Instant> parse_instant(std::string_view text) {
  if (const std::optional<double> seconds = parse_number(text)) {
    const double whole = std::floor(*seconds);
    if (std::fabs(whole) > 1e15) {
      return std::nullopt;
    }
    return Instant{Instant::Kind::kSeconds, static_cast<std::int64_t>(whole), *seconds - whole};
  }
  return parse_date_and_time(text);
}

}  // namespace gsbench::recording
