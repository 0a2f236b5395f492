// Sample messages of every kind with all kinds of values, and messages as lists of fields.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <wire/frame.hpp>

namespace gs::wire::test {

using Bytes = std::vector<std::uint8_t>;

// One field as on the wire. The contents of a map or an array follow as further fields; those of a
// map are alternating keys and values.
struct Field {
  enum class Type { kInteger, kSingle, kBoolean, kText, kMap, kArray };
  Type type = Type::kInteger;
  std::int64_t number = 0;  // an integer, 0 or 1, the bits of a float, or a count of items
  std::string text;
};

bool operator==(const Field& a, const Field& b);
void PrintTo(const Field& field, std::ostream* out);

// The fields after the head, in order.
std::vector<Field> fields_of(const Uplink& message);
std::vector<Field> fields_of(const Downlink& message);
std::vector<Field> fields_of(const outlet::Settings& settings);

// How a message's fields are filled.
enum class Fill {
  kLowest,    // least integers, −∞, no text, first enumerators, no rows
  kHighest,   // greatest integers, +∞, longest text, last enumerators, 32 rows
  kLongest,   // values with the longest encoding: negative integers, 32 rows
  kNaN,       // floats are a NaN with unusual bits; otherwise as kHighest
  kAnything,  // random, including special values
};

Uplink uplink(UplinkKind kind, Fill fill, std::mt19937& random);
Downlink downlink(DownlinkKind kind, Fill fill, std::mt19937& random);

std::vector<UplinkKind> uplink_kinds();
std::vector<DownlinkKind> downlink_kinds();

// Every kind with every fill, kAnything `times` times each. Identical on every machine.
std::vector<Uplink> many_uplinks(int times);
std::vector<Downlink> many_downlinks(int times);

// Result of encode() into a buffer of the longest message's size; empty if it fails.
Bytes encoded(const Uplink& message, std::uint32_t sequence);
Bytes encoded(const Downlink& message, std::uint32_t sequence);
Bytes encoded(const outlet::Settings& settings);
Bytes framed(const Bytes& message);
// The frames that the reader finds: for each the message, or empty bytes for a bad frame.
std::vector<Bytes> frames_in(FrameReader& reader, const Bytes& stream);

std::string hex(const Bytes& bytes);

}  // namespace gs::wire::test
