// The subset of CBOR (RFC 8949) that messages use: integers, single-precision floats, booleans,
// short text, arrays and maps of definite length. No heap, no recursion.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::wire::cbor {

// Writes items while they fit. Once an item did not fit, ok() is false. Integers are written in
// their shortest form.
class Writer {
 public:
  Writer(std::uint8_t* out, std::size_t capacity) : out_(out), capacity_(capacity) {}

  void array(std::size_t items) { head(4, items); }
  void map(std::size_t pairs) { head(5, pairs); }
  void unsigned_integer(std::uint64_t value) { head(0, value); }
  void integer(std::int64_t value);
  void single(float value);  // any NaN as 0x7FC00000
  void boolean(bool value) { put(value ? 0xF5 : 0xF4); }
  void text(const char* text, std::size_t length);

  bool ok() const { return ok_; }
  std::size_t size() const { return size_; }

 private:
  void put(std::uint8_t byte);
  void head(std::uint8_t major, std::uint64_t value);

  std::uint8_t* out_;
  std::size_t capacity_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

// Each call reads one item. It returns false, and does not advance, if the next item has another
// type or is truncated.
class Reader {
 public:
  Reader(const std::uint8_t* bytes, std::size_t size) : at_(bytes), end_(bytes + size) {}

  [[nodiscard]] bool array(std::size_t& items) { return container(kArray, 1, items); }
  [[nodiscard]] bool map(std::size_t& pairs) { return container(kMap, 2, pairs); }
  [[nodiscard]] bool unsigned_integer(std::uint64_t& value);
  [[nodiscard]] bool integer(std::int64_t& value);
  [[nodiscard]] bool single(float& value);
  [[nodiscard]] bool boolean(bool& value);
  // Reads up to `most` characters of printable ASCII; writes them and a terminating zero.
  [[nodiscard]] bool text(char* out, std::size_t most);
  // Skips one item of any type, with all it contains.
  [[nodiscard]] bool skip();

  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  struct Head {
    std::uint8_t major = kNone;
    std::uint8_t info = 0;
    std::uint64_t value = 0;
    const std::uint8_t* end = nullptr;
  };
  // Major types; kNone marks a truncated or invalid item.
  static constexpr std::uint8_t kArray = 4;
  static constexpr std::uint8_t kMap = 5;
  static constexpr std::uint8_t kNone = 0xFF;

  Head peek() const;
  bool pass(const Head& head);  // advances past the item; always returns true
  bool container(std::uint8_t wanted, std::size_t items_each, std::size_t& count);

  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

}  // namespace gs::wire::cbor
