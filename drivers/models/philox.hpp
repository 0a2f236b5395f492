// Philox 4×32-10 as this library counts with it: the seed is the key; block number, purpose and
// index are the counter.
#pragma once

#include <cstdint>

#include <Random123/philox.h>

#include <models/noise.hpp>

namespace gsbench::models {

inline r123::Philox4x32::ctr_type philox_block(const Stream& stream, std::uint64_t block) {
  const r123::Philox4x32::ctr_type counter = {{static_cast<std::uint32_t>(block),
                                               static_cast<std::uint32_t>(block >> 32),
                                               stream.purpose, stream.index}};
  const r123::Philox4x32::key_type key = {
      {static_cast<std::uint32_t>(stream.seed), static_cast<std::uint32_t>(stream.seed >> 32)}};
  return r123::Philox4x32{}(counter, key);
}

}  // namespace gsbench::models
