#include "columns.hpp"

#include <zlib.h>

#include <cstddef>
#include <cstring>
#include <new>
#include <type_traits>

namespace gsbench::record::columns {
namespace {

// Deflate compresses by at most 1032 : 1 (zlib's technical notes). A blob that claims more is
// damaged; no memory is allocated for it.
constexpr std::uint64_t kGreatestRatio = 1032;

Bytes deflated(const Bytes& raw) {
  uLongf size = compressBound(static_cast<uLong>(raw.size()));
  Bytes blob(size);
  if (compress2(blob.data(), &size, raw.data(), static_cast<uLong>(raw.size()),
                Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();  // the only possible failure, as the buffer has zlib's own bound
  }
  blob.resize(size);
  return blob;
}

Bytes inflated(const Bytes& blob, std::int64_t entries, std::size_t entry_bytes) {
  const std::uint64_t greatest = blob.size() * kGreatestRatio / entry_bytes;
  if (entries < 0 || static_cast<std::uint64_t>(entries) > greatest) {
    throw DamagedColumn("a column is too short for its number of entries");
  }
  // One spare byte, so that a longer column is noticed and an empty one has an address.
  Bytes raw(static_cast<std::size_t>(entries) * entry_bytes + 1);
  uLongf size = static_cast<uLongf>(raw.size());
  const int status = uncompress(raw.data(), &size, blob.data(), static_cast<uLong>(blob.size()));
  if (status != Z_OK || size + 1 != raw.size()) {
    throw DamagedColumn("a column cannot be decompressed");
  }
  raw.pop_back();
  return raw;
}

template <class Value>
Bytes grouped(const std::vector<Value>& values) {
  Bytes raw(values.size() * sizeof(Value));
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint8_t bytes[sizeof(Value)];
    std::memcpy(bytes, &values[i], sizeof(Value));
    for (std::size_t b = 0; b < sizeof(Value); ++b) {
      raw[b * values.size() + i] = bytes[b];
    }
  }
  return raw;
}

template <class Value>
void ungroup(const Bytes& raw, std::vector<Value>& values) {
  values.resize(raw.size() / sizeof(Value));
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::uint8_t bytes[sizeof(Value)];
    for (std::size_t b = 0; b < sizeof(Value); ++b) {
      bytes[b] = raw[b * values.size() + i];
    }
    std::memcpy(&values[i], bytes, sizeof(Value));
  }
}

// Unsigned differences: any ticks, also from a forged file, wrap and are restored without overflow.
std::vector<std::uint64_t> second_differences(const std::vector<std::int64_t>& ticks) {
  std::vector<std::uint64_t> differences;
  differences.reserve(ticks.size());
  std::uint64_t previous = 0;
  std::uint64_t previous_step = 0;
  for (const std::int64_t tick : ticks) {
    const std::uint64_t step = static_cast<std::uint64_t>(tick) - previous;
    differences.push_back(step - previous_step);
    previous = static_cast<std::uint64_t>(tick);
    previous_step = step;
  }
  return differences;
}

// In place: second differences become ticks.
void sum_twice(std::vector<std::int64_t>& ticks) {
  std::uint64_t tick = 0;
  std::uint64_t step = 0;
  for (std::int64_t& value : ticks) {
    step += static_cast<std::uint64_t>(value);
    tick += step;
    value = static_cast<std::int64_t>(tick);
  }
}

}  // namespace

template <class Value>
Bytes pack(const std::vector<Value>& values) {
  if constexpr (std::is_same_v<Value, std::int64_t>) {
    return deflated(grouped(second_differences(values)));
  }
  return deflated(grouped(values));
}

template <class Value>
void unpack(const Bytes& blob, std::int64_t entries, std::vector<Value>& values) {
  ungroup(inflated(blob, entries, sizeof(Value)), values);
  if constexpr (std::is_same_v<Value, std::int64_t>) {
    sum_twice(values);
  }
}

template Bytes pack(const std::vector<std::int64_t>&);
template Bytes pack(const std::vector<float>&);
template Bytes pack(const std::vector<double>&);
template Bytes pack(const std::vector<std::uint8_t>&);
template void unpack(const Bytes&, std::int64_t, std::vector<std::int64_t>&);
template void unpack(const Bytes&, std::int64_t, std::vector<float>&);
template void unpack(const Bytes&, std::int64_t, std::vector<double>&);
template void unpack(const Bytes&, std::int64_t, std::vector<std::uint8_t>&);

}  // namespace gsbench::record::columns
