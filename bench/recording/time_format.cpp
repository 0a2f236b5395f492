#include "instant.hpp"
#include "time_scanner.hpp"

namespace gsbench::recording {
namespace {

constexpr std::string_view kDirectives = "YymdbHIpMSz%";

class FormatParser {
 public:
  explicit FormatParser(std::string_view text) : scanner_(text) {
    parts_.time.tm_year = 70;
    parts_.time.tm_mday = 1;
  }

  std::optional<Instant> parse(const std::string& format) {
    for (std::size_t i = 0; i < format.size(); ++i) {
      if (format[i] == ' ') {
        scanner_.blanks();
      } else if (format[i] != '%' || i + 1 == format.size()) {
        scanner_.expect(format[i]);
      } else {
        read(format[++i]);
      }
    }
    if (half_) {
      const bool exists = parts_.time.tm_hour >= 1 && parts_.time.tm_hour <= 12;
      parts_.time.tm_hour = exists ? parts_.time.tm_hour % 12 + *half_ : -1;
    }
    return scanner_.good_and_done() ? instant_of(parts_) : std::nullopt;
  }

 private:
  void read(char directive) {
    std::tm& time = parts_.time;
    switch (directive) {
      case 'Y':
        time.tm_year = scanner_.digits(4) - 1900;
        break;
      case 'y': {  // as strptime: 69 … 99 are of the 20th century
        const int year = scanner_.digits(2);
        time.tm_year = year < 69 ? year + 100 : year;
        break;
      }
      case 'm':
        time.tm_mon = scanner_.digits(1, 2) - 1;
        break;
      case 'd':
        time.tm_mday = scanner_.digits(1, 2);
        break;
      case 'b':
        time.tm_mon = scanner_.month_name() - 1;
        break;
      case 'H':
      case 'I':
        time.tm_hour = scanner_.digits(1, 2);
        break;
      case 'p':
        half_ = scanner_.half_of_day();
        break;
      case 'M':
        time.tm_min = scanner_.digits(2);
        break;
      case 'S':
        time.tm_sec = scanner_.digits(2);
        parts_.fraction_s = scanner_.fraction();
        break;
      case 'z':
        parts_.offset_s = scanner_.offset_s();
        if (!parts_.offset_s) {
          scanner_.fail();
        }
        break;
      default:
        scanner_.expect(directive);
    }
  }

  TimeScanner scanner_;
  TimeParts parts_;
  std::optional<int> half_;
};

}  // namespace

std::optional<Instant> parse_by_format(std::string_view text, const std::string& format) {
  return FormatParser(text).parse(format);
}

std::string unknown_directive(const std::string& format) {
  for (std::size_t i = 0; i < format.size(); ++i) {
    if (format[i] != '%') {
      continue;
    }
    std::string directive = format.substr(i++, 2);
    if (directive.size() < 2 || kDirectives.find(directive[1]) == std::string_view::npos) {
      return directive;
    }
  }
  return "";
}

}  // namespace gsbench::recording
