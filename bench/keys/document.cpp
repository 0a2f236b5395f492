#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <toml++/toml.h>

#include <keys/document.hpp>

namespace gsbench::keys {
namespace {

// The files of this project are nested five deep.
constexpr std::size_t kDeepestNesting = 64;

Position position_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

Value convert(const toml::node& node);

Entries convert_table(const toml::table& table) {
  Entries entries;
  entries.reserve(table.size());
  for (const auto& [key, node] : table) {
    entries.push_back({std::string(key.str()), position_of(key.source()), convert(node)});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return std::tie(a.at.line, a.at.column) < std::tie(b.at.line, b.at.column);
  });
  return entries;
}

Value convert(const toml::node& node) {
  Value value{DateOrTime{}, position_of(node.source())};
  node.visit([&](const auto& content) {
    using Content = decltype(content);
    if constexpr (toml::is_table<Content>) {
      value.data = convert_table(content);
    } else if constexpr (toml::is_array<Content>) {
      auto& items = value.data.emplace<Array>();
      for (const toml::node& item : content) {
        items.push_back(convert(item));
      }
    } else if constexpr (toml::is_chronological<Content>) {
      std::ostringstream text;
      text << content.get();
      value.data = DateOrTime{text.str()};
    } else {
      value.data = content.get();
    }
  });
  return value;
}

// Refuses nesting that is too deep before the TOML library parses it: its recursion would overflow
// the stack. Each dot of a key and each bracket is one level. The dot of a number counts as well,
// until the next comma.
class NestingCheck {
 public:
  NestingCheck(const std::string& text, const std::string& path) : text_(text), path_(path) {}

  void run() {
    while (at_ < text_.size()) {
      switch (text_[at_]) {
        case '"':
        case '\'':
          skip_text(text_[at_]);
          continue;
        case '#':
          at_ = std::min(text_.find('\n', at_), text_.size());
          continue;
        case '[':
        case '{':
          deeper();
          dots_.push_back(0);
          break;
        case ']':
        case '}':
          leave();
          break;
        case ',':
          leave_key();
          break;
        case '.':
          deeper();
          ++dots_.back();
          break;
        case '\n':
          end_line();
          break;
        default:
          break;
      }
      ++at_;
    }
  }

 private:
  void deeper() {
    if (++depth_ > kDeepestNesting) {
      throw error_at(
          path_, {line_, static_cast<int>(at_ - line_start_) + 1},
          fmt::format("nested {} levels deep; the maximum is {}", depth_, kDeepestNesting));
    }
  }

  void leave_key() {
    depth_ -= dots_.back();
    dots_.back() = 0;
  }

  void leave() {
    if (dots_.size() == 1) {
      return;  // the TOML library reports it
    }
    depth_ -= dots_.back() + 1;
    dots_.pop_back();
  }

  void end_line() {
    if (dots_.size() == 1) {
      leave_key();
    }
    ++line_;
    line_start_ = at_ + 1;
  }

  // A text in single or double quotes, or in three of them, which may span lines.
  void skip_text(char quote) {
    const std::string three(3, quote);
    const bool long_text = text_.compare(at_, 3, three) == 0;
    at_ += long_text ? 3 : 1;
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '\n') {
        if (!long_text) {
          return;  // the TOML library reports it
        }
        ++line_;
        line_start_ = at_ + 1;
      } else if (text_[at_] == '\\' && quote == '"') {
        ++at_;
      } else if (long_text ? text_.compare(at_, 3, three) == 0 : text_[at_] == quote) {
        at_ += long_text ? 3 : 1;
        // A text in three quotes may itself end in one or two quotes.
        for (int own = 0; long_text && own < 2 && at_ < text_.size() && text_[at_] == quote;
             ++own) {
          ++at_;
        }
        return;
      }
    }
  }

  const std::string& text_;
  const std::string& path_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::size_t line_start_ = 0;
  std::size_t depth_ = 0;  // open brackets and the dots counted
  // Dots of the current key: outside all brackets, then within each open bracket.
  std::vector<std::size_t> dots_ = {0};
};

struct Describe {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return fmt::format("{}", value); }
  // With a decimal point, so that a message shows why 8000.0 is not a whole number.
  std::string operator()(double value) const {
    const std::string digits = fmt::format("{}", value);
    return digits.find_first_not_of("-0123456789") == std::string::npos ? digits + ".0" : digits;
  }
  std::string operator()(const std::string& value) const {
    return fmt::format("the text \"{}\"", value);
  }
  std::string operator()(const DateOrTime&) const { return "a date or time"; }
  std::string operator()(const Array&) const { return "an array"; }
  std::string operator()(const Entries&) const { return "a table"; }
};

}  // namespace

Document parse_toml(const std::string& text, const std::string& path) {
  if (const std::string start = text.substr(0, 2); start == "\xFF\xFE" || start == "\xFE\xFF") {
    throw error_at(path, {1, 1}, "the file is text in UTF-16; save it as UTF-8");
  }
  NestingCheck(text, path).run();
  try {
    return {path, convert(toml::parse(text))};
  } catch (const toml::parse_error& error) {
    throw error_at(path, position_of(error.source()),
                   fmt::format("invalid TOML: {}", error.description()));
  }
}

ConfigurationError error_at(const std::string& path, Position at, const std::string& message) {
  return ConfigurationError(fmt::format("{}:{}:{}: {}", path, at.line, at.column, message));
}

std::string quoted(const std::string& text) {
  std::ostringstream out;
  const toml::value<std::string> value(text);
  out << toml::toml_formatter(value, toml::format_flags::none);
  return out.str();
}

std::string describe(const Value& value) {
  return std::visit(Describe{}, value.data);
}

}  // namespace gsbench::keys
