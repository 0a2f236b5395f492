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

Bytes pack(const std::vector<std::int64_t>& ticks);
Bytes pack(const std::vector<float>& values);
Bytes pack(const std::vector<double>& values);
Bytes pack(const std::vector<std::uint8_t>& values);

// Throw DamagedColumn unless the blob holds exactly `entries` entries.
void unpack(const Bytes& blob, std::int64_t entries, std::vector<std::int64_t>& ticks);
void unpack(const Bytes& blob, std::int64_t entries, std::vector<float>& values);
void unpack(const Bytes& blob, std::int64_t entries, std::vector<double>& values);
void unpack(const Bytes& blob, std::int64_t entries, std::vector<std::uint8_t>& values);

}  // namespace gsbench::record::columns
