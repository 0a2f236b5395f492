// Parses times from the left.
#pragma once

#include "instant.hpp"

#include <array>
#include <cctype>
#include <cstddef>
#include <ctime>
#include <optional>
#include <string>
#include <string_view>

namespace gsbench::recording {

// After the first error, good_and_done() is false.
class TimeScanner {
 public:
  explicit TimeScanner(std::string_view text) : rest_(text) {}

  int digits(std::size_t least, std::size_t most) {
    int value = 0;
    std::size_t count = 0;
    while (count < most && !rest_.empty() && rest_.front() >= '0' && rest_.front() <= '9') {
      value = 10 * value + (take() - '0');
      ++count;
    }
    good_ = good_ && count >= least;
    return value;
  }
  int digits(std::size_t count) { return digits(count, count); }

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

  void blanks() {
    good_ = good_ && accept(' ');
    while (accept(' ')) {
    }
  }

  // Jan … Dec, upper or lower case, as 1 … 12.
  int month_name() {
    constexpr std::array<std::string_view, 12> kNames = {"jan", "feb", "mar", "apr", "may", "jun",
                                                         "jul", "aug", "sep", "oct", "nov", "dec"};
    const std::string name = word(3);
    for (std::size_t i = 0; i < kNames.size(); ++i) {
      if (name == kNames[i]) {
        return static_cast<int>(i) + 1;
      }
    }
    good_ = false;
    return 0;
  }

  // AM as 0, PM as 12 hours.
  int half_of_day() {
    const std::string half = word(2);
    good_ = good_ && (half == "am" || half == "pm");
    return half == "pm" ? 12 : 0;
  }

  // ".5" as 0.5; without a decimal sign 0. ISO 8601 has a comma.
  double fraction() {
    if (rest_.empty() || (rest_.front() != '.' && rest_.front() != ',')) {
      return 0.0;
    }
    std::size_t length = 1;
    while (length < rest_.size() && rest_[length] >= '0' && rest_[length] <= '9') {
      ++length;
    }
    const std::optional<double> value =
        parse_number("." + std::string(rest_.substr(1, length - 1)));
    rest_.remove_prefix(length);
    good_ = good_ && length > 1 && value.has_value();
    return value.value_or(0.0);
  }

  // "Z", "+02:00", "+0200", in seconds; nullopt without one.
  std::optional<int> offset_s() {
    const bool east = accept('+');
    if (east || accept('-')) {
      const int hours = digits(2);
      accept(':');
      return (east ? 60 : -60) * (60 * hours + digits(2));
    }
    return accept('Z') ? std::optional<int>(0) : std::nullopt;
  }

  void fail() { good_ = false; }
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

  std::string word(int letters) {
    std::string text;
    for (int i = 0; i < letters; ++i) {
      text += static_cast<char>(std::tolower(static_cast<unsigned char>(take())));
    }
    return text;
  }

  std::string_view rest_;
  bool good_ = true;
};

struct TimeParts {
  std::tm time{};
  double fraction_s = 0.0;
  std::optional<int> offset_s;
};

// nullopt for a time that does not exist.
std::optional<Instant> instant_of(const TimeParts& parts);

}  // namespace gsbench::recording
