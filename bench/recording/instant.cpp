#include "instant.hpp"

#include "number.hpp"

#include <array>
#include <cctype>
#include <cmath>
#include <string>

namespace gsbench::recording {
namespace {

// Takes a text apart from the left; once something is not as it should be, `good` stays false.
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
    if (take() != wanted) good_ = false;
  }

  bool accept(char wanted) {
    if (rest_.empty() || rest_.front() != wanted) return false;
    rest_.remove_prefix(1);
    return true;
  }

  // Jan … Dec, in any case: 1 … 12.
  int month_name() {
    constexpr std::array<std::string_view, 12> kNames = {"jan", "feb", "mar", "apr", "may", "jun",
                                                         "jul", "aug", "sep", "oct", "nov", "dec"};
    std::string name;
    for (int i = 0; i < 3; ++i) {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(take())));
    }
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (name == kNames[i]) return static_cast<int>(i) + 1;
    }
    good_ = false;
    return 0;
  }

  // ".5" as 0.5; nothing as 0.
  double fraction() {
    if (rest_.empty() || rest_.front() != '.') return 0.0;
    std::size_t length = 1;
    while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') ++length;
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

struct Date {
  int year = 0;
  int month = 0;
  int day = 0;
};

bool exists(const Date& date) {
  constexpr std::array<int, 12> kDays = {31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (date.month < 1 || date.month > 12 || date.day < 1) return false;
  const bool leap = (date.year % 4 == 0 && date.year % 100 != 0) || date.year % 400 == 0;
  const int days = kDays[static_cast<std::size_t>(date.month - 1)];
  return date.day <= (date.month == 2 && leap ? 29 : days);
}

// Days since 1 March of the year 0 in the Gregorian calendar: years that begin in March have the
// leap day at their end.
std::int64_t day_number(const Date& date) {
  const std::int64_t year = date.month > 2 ? date.year : date.year - 1;
  const std::int64_t month = (date.month + 9) % 12;
  return 365 * year + year / 4 - year / 100 + year / 400 + (153 * month + 2) / 5 + date.day - 1;
}

std::optional<Instant> parse_date_and_time(std::string_view text) {
  Scanner scanner(text);
  Date date;
  const bool day_first = text.size() > 2 && text[2] == '-';
  if (day_first) {
    date.day = scanner.digits(2);
    scanner.expect('-');
    date.month = scanner.month_name();
    scanner.expect('-');
    date.year = scanner.digits(4);
  } else {
    date.year = scanner.digits(4);
    scanner.expect('-');
    date.month = scanner.digits(2);
    scanner.expect('-');
    date.day = scanner.digits(2);
  }
  if (!scanner.accept('T')) scanner.expect(' ');
  const int hour = scanner.digits(2);
  scanner.expect(':');
  const int minute = scanner.digits(2);
  scanner.expect(':');
  const int second = scanner.digits(2);
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

  if (!scanner.good_and_done() || !exists(date) || hour > 23 || minute > 59 || second > 59) {
    return std::nullopt;
  }
  instant.whole_s = ((day_number(date) * 24 + hour) * 60 + minute - offset_minutes) * 60 + second;
  return instant;
}

}  // namespace

std::optional<Instant> parse_instant(std::string_view text) {
  if (const std::optional<double> seconds = parse_number(text)) {
    const double whole = std::floor(*seconds);
    if (std::fabs(whole) > 1e15) return std::nullopt;
    return Instant{Instant::Kind::kSeconds, static_cast<std::int64_t>(whole), *seconds - whole};
  }
  return parse_date_and_time(text);
}

}  // namespace gsbench::recording
