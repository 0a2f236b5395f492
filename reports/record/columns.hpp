// Columns of numbers as small blobs, exact to the bit: ticks as second differences (a regular
// series becomes zeros), then the bytes of all entries grouped by their place (the slow upper bytes
// of a float stand together), then deflate, whose check sum tells a damaged blob.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace gsbench::record::columns {

using Bytes = std::vector<std::uint8_t>;

// The blob does not hold the column it should.
class DamagedColumn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Value: std::int64_t, which are ticks, float, double or std::uint8_t.
template <class Value>
Bytes pack(const std::vector<Value>& values);

// Throws DamagedColumn unless the blob holds exactly `entries` entries.
template <class Value>
void unpack(const Bytes& blob, std::int64_t entries, std::vector<Value>& values);

}  // namespace gsbench::record::columns
