// The syntax that instruments share: SCPI-1999 volume 1 (headers, chains, numbers) and IEEE 488.2
// section 7 (blocks).
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace gsbench::emulation {

bool is_space(char c);
std::string upper(std::string_view text);
std::string_view left_trimmed(std::string_view text);
std::string_view trimmed(std::string_view text);
// Splits at commas outside quotes; the parts are trimmed. No part for an empty text.
std::vector<std::string_view> fields_of(std::string_view text);
std::string unquoted(std::string_view text);

// "1000", "1e3HZ", "1 kHz", "500 mVpp", "INF". M is mega before Hz, Sa/s and Ω, else milli.
std::optional<double> number_of(std::string_view text);
std::optional<bool> switch_of(std::string_view text);  // ON, OFF, 1, 0
// Whether `text` is the short or the long form of `name`, such as "SINusoid".
bool is_form_of(std::string_view text, std::string_view name);

// Whether a header is one of `pattern`, such as "[SOURce:]FUNCtion:ARBitrary:SRATe" without a
// leading colon. The channel 1 may be written on any node: SOUR1, OUTP1.
bool matches(std::string_view header, std::string_view pattern);

// A part of a message between semicolons.
struct ScpiUnit {
  std::string header;  // upper case, absolute, without leading colon and '?'
  bool query = false;
  std::string_view argument;  // trimmed, but not the bytes of a block at its end
};
// Splits a message at semicolons outside quotes and blocks, and resolves headers that are relative
// to the one before.
std::vector<ScpiUnit> units_of(std::string_view message);

// The bytes of "#<digits><length><bytes>"; none if it is not such a block or not complete.
std::optional<std::string_view> block_of(std::string_view text);

// Finds the end of a message that may hold blocks with any byte.
class ScpiFraming {
 public:
  // The size of the first message in `bytes`, with its newline; 0: not complete.
  std::size_t message_size(std::string_view bytes);
  // Whether the last message looked at ends within a block.
  bool in_block() const { return in_block_; }
  void forget() { *this = {}; }

 private:
  std::size_t scanned_ = 0;  // of an incomplete message
  char quote_ = 0;
  bool in_block_ = false;
};

// The queue of SYSTem:ERRor? (SCPI-1999 volume 2, section 21.8).
class ScpiErrors {
 public:
  ScpiErrors(std::size_t longest, bool signs) : longest_(longest), signs_(signs) {}
  // Replaces the last error by -350 if the queue is full.
  void add(int number, std::string_view text);
  std::string next();  // "0,\"No error\"" if there is none
  void clear() { errors_.clear(); }
  void fill() {
    while (errors_.size() < longest_) {
      add(-100, "Command error");
    }
    add(-100, "Command error");
  }

 private:
  std::size_t longest_;
  bool signs_;  // "+0" instead of "0"
  std::deque<std::pair<int, std::string>> errors_;
};

}  // namespace gsbench::emulation
