#include "instant.hpp"

#include "time_scanner.hpp"

namespace gsbench::recording {

std::optional<Instant> instant_of(const TimeParts& parts) {
  // timegm() changes a date that does not exist, such as 30 February, to one that does.
  const std::tm& time = parts.time;
  std::tm real = time;
  Instant instant;
  instant.kind = parts.offset_s ? Instant::Kind::kZoned : Instant::Kind::kLocal;
  instant.offset_s = parts.offset_s.value_or(0);
  instant.whole_s = timegm(&real) - instant.offset_s;
  instant.fraction_s = parts.fraction_s;
  const bool exists = real.tm_mon == time.tm_mon && real.tm_mday == time.tm_mday &&
                      real.tm_hour == time.tm_hour && real.tm_min == time.tm_min &&
                      real.tm_sec == time.tm_sec;
  return exists ? std::optional<Instant>(instant) : std::nullopt;
}

std::optional<Instant> instant_of_number(double seconds) {
  const double whole = std::floor(seconds);
  if (std::fabs(whole) > 1e15) {
    return std::nullopt;
  }
  return Instant{Instant::Kind::kSeconds, static_cast<std::int64_t>(whole), seconds - whole};
}

std::optional<Instant> parse_date_and_time(std::string_view text, Lacking lacking) {
  TimeScanner scanner(text);
  TimeParts parts;
  const bool day_first = text.size() > 2 && text[2] == '-';
  if (day_first) {
    parts.time.tm_mday = scanner.digits(2);
    scanner.expect('-');
    parts.time.tm_mon = scanner.month_name() - 1;
    scanner.expect('-');
    parts.time.tm_year = scanner.digits(4) - 1900;
  } else {
    parts.time.tm_year = scanner.digits(4) - 1900;
    scanner.expect('-');
    parts.time.tm_mon = scanner.digits(2) - 1;
    scanner.expect('-');
    parts.time.tm_mday = scanner.digits(2);
  }
  if (lacking == Lacking::kSecondsOrTime && scanner.good_and_done()) {
    return instant_of(parts);
  }
  if (!scanner.accept('T')) {
    scanner.expect(' ');
  }
  parts.time.tm_hour = scanner.digits(2);
  scanner.expect(':');
  parts.time.tm_min = scanner.digits(2);
  if (scanner.accept(':')) {
    parts.time.tm_sec = scanner.digits(2);
    parts.fraction_s = scanner.fraction();
  } else if (lacking == Lacking::kNothing) {
    scanner.fail();
  }
  parts.offset_s = scanner.offset_s();
  return scanner.good_and_done() ? instant_of(parts) : std::nullopt;
}

}  // namespace gsbench::recording
