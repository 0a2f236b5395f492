// Lossless compression of columns of numbers. Ticks are stored as second differences, which are
// zero for a regular series. The bytes of all entries are then grouped by significance, because the
// upper bytes of floats change slowly. The grouped bytes are deflated. The checksum of deflate
// detects a damaged blob.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

namespace gsbench::record::columns {

using Bytes = std::vector<std::uint8_t>;

// The blob does not hold the expected column.
class DamagedColumn : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Value: std::int64_t (ticks), float, double or std::uint8_t.
template <class Value>
Bytes pack(const std::vector<Value>& values);

// Throws DamagedColumn unless the blob holds exactly `entries` entries.
template <class Value>
void unpack(const Bytes& blob, std::int64_t entries, std::vector<Value>& values);

}  // namespace gsbench::record::columns
