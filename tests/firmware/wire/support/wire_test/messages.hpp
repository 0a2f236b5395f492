// Messages of every kind with values of every sort, and what a message holds as a list of fields.
#pragma once

#include <cstdint>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include <wire/frame.hpp>

namespace gs::wire::test {

using Bytes = std::vector<std::uint8_t>;

// One field as it stands on the wire. What a map or an array holds stands behind it: of a map its
// keys and values in turn.
struct Field {
  enum class Type { kInteger, kSingle, kBoolean, kText, kMap, kArray };
  Type type = Type::kInteger;
  std::int64_t number = 0;  // an integer, 0 or 1, the bits of a float, or how many it holds
  std::string text;
};

bool operator==(const Field& a, const Field& b);
void PrintTo(const Field& field, std::ostream* out);

// The fields behind the head, in order.
std::vector<Field> fields_of(const Uplink& message);
std::vector<Field> fields_of(const Downlink& message);
std::vector<Field> fields_of(const outlet::Settings& settings);

// How a message's fields are filled.
enum class Fill {
  kLowest,    // least integers, −∞, no text, first enumerators, no rows
  kHighest,   // greatest integers, +∞, longest text, last enumerators, 32 rows
  kLongest,   // what takes the most bytes: negative integers, 32 rows
  kNaN,       // floats with bits that no arithmetic makes; else as kHighest
  kAnything,  // random, special values among them
};

Uplink uplink(UplinkKind kind, Fill fill, std::mt19937& random);
Downlink downlink(DownlinkKind kind, Fill fill, std::mt19937& random);

std::vector<UplinkKind> uplink_kinds();
std::vector<DownlinkKind> downlink_kinds();

// Every kind with every fill, kAnything `times` times each. The same on every machine.
std::vector<Uplink> many_uplinks(int times);
std::vector<Downlink> many_downlinks(int times);

// As encode() makes them, in a buffer of the longest message's size; empty where it refuses.
Bytes encoded(const Uplink& message, std::uint32_t sequence);
Bytes encoded(const Downlink& message, std::uint32_t sequence);
Bytes encoded(const outlet::Settings& settings);
Bytes framed(const Bytes& message);
// What the reader finds, one entry a frame: the message, or nothing for a bad frame.
std::vector<Bytes> frames_in(FrameReader& reader, const Bytes& stream);

std::string hex(const Bytes& bytes);

}  // namespace gs::wire::test
