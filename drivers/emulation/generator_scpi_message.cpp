// Messages: their ends, parts and blocks; the error queue.
#include "generator_scpi.hpp"

#include <algorithm>

namespace gsbench::emulation {

namespace {

// The size of the block that starts at `at`, with its header: 0 if none starts there; npos if it
// is not complete.
std::size_t block_size(std::string_view text, std::size_t at) {
  if (text[at] != '#') {
    return 0;
  }
  if (at + 1 == text.size()) {
    return std::string_view::npos;
  }
  const char digits = text[at + 1];
  if (digits < '1' || digits > '9') {
    return 0;
  }
  std::size_t length = 0;
  const std::size_t start = at + 2 + static_cast<std::size_t>(digits - '0');
  for (std::size_t i = at + 2; i < start; ++i) {
    if (i == text.size()) {
      return std::string_view::npos;
    }
    if (!(text[i] >= '0' && text[i] <= '9')) {
      return 0;
    }
    length = length * 10 + static_cast<std::size_t>(text[i] - '0');
  }
  return start + length > text.size() ? std::string_view::npos : start + length - at;
}

}  // namespace

std::vector<ScpiUnit> units_of(std::string_view message) {
  std::vector<ScpiUnit> units;
  std::string path;  // of the header before, without its last node
  std::size_t start = 0;
  std::size_t block_end = 0;  // bytes of a block are no white space
  char quote = 0;
  for (std::size_t i = 0; i <= message.size(); ++i) {
    if (i < message.size()) {
      const char c = message[i];
      if (quote != 0) {
        quote = c == quote ? char{0} : quote;
        continue;
      }
      if (c == '"' || c == '\'') {
        quote = c;
        continue;
      }
      if (const std::size_t block = block_size(message, i);
          block != 0 && block != std::string_view::npos) {
        block_end = i + block;
        i = block_end - 1;
        continue;
      }
      if (c != ';') {
        continue;
      }
    }
    std::size_t end = i;
    while (end > std::max(start, block_end) && is_space(message[end - 1])) {
      --end;
    }
    const std::string_view text = left_trimmed(message.substr(start, end - start));
    start = i + 1;
    if (text.empty()) {
      continue;
    }
    ScpiUnit unit;
    const auto space = std::find_if(text.begin(), text.end(), is_space) - text.begin();
    std::string header = upper(text.substr(0, static_cast<std::size_t>(space)));
    unit.argument = left_trimmed(text.substr(static_cast<std::size_t>(space)));
    if (header.back() == '?') {
      unit.query = true;
      header.pop_back();
    }
    if (!header.empty() && header.front() == ':') {
      header.erase(0, 1);
      path.clear();
    } else if (header.empty() || header.front() != '*') {
      header.insert(0, path);
    }
    if (header.empty() || header.front() != '*') {
      const auto last = header.rfind(':');
      path = last == std::string::npos ? "" : header.substr(0, last + 1);
    }
    unit.header = std::move(header);
    units.push_back(std::move(unit));
  }
  return units;
}

std::optional<std::string_view> block_of(std::string_view text) {
  if (text.empty()) {
    return std::nullopt;
  }
  const std::size_t size = block_size(text, 0);
  if (size == 0 || size == std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t header = 2 + static_cast<std::size_t>(text[1] - '0');
  return text.substr(header, size - header);
}

std::size_t ScpiFraming::message_size(std::string_view bytes) {
  in_block_ = false;
  for (; scanned_ < bytes.size(); ++scanned_) {
    const char c = bytes[scanned_];
    if (c == '\n') {
      const std::size_t size = scanned_ + 1;
      forget();
      return size;
    }
    if (quote_ != 0) {
      quote_ = c == quote_ ? char{0} : quote_;
    } else if (c == '"' || c == '\'') {
      quote_ = c;
    } else if (const std::size_t block = block_size(bytes, scanned_); block != 0) {
      if (block == std::string_view::npos) {
        in_block_ = true;
        return 0;
      }
      scanned_ += block - 1;
    }
  }
  return 0;
}

void ScpiErrors::add(int number, std::string_view text) {
  if (errors_.size() < longest_) {
    errors_.emplace_back(number, text);
  } else {
    errors_.back() = {-350, "Queue overflow"};
  }
}

std::string ScpiErrors::next() {
  if (errors_.empty()) {
    return signs_ ? "+0,\"No error\"" : "0,\"No error\"";
  }
  const auto [number, text] = errors_.front();
  errors_.pop_front();
  return (signs_ && number > 0 ? "+" : "") + std::to_string(number) + ",\"" + text + "\"";
}

}  // namespace gsbench::emulation
