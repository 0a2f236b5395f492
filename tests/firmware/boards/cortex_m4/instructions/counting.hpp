// The arguments of count_ticks() in the emulated processor's memory. Addresses are those of the
// board.
#pragma once

#include <cstdint>

#include <outlet/outlet.hpp>

namespace gs::test {

enum class Counted : std::uint32_t {
  kNothing = 0,  // the cost of reading the counter
  kLoop = 1,     // `rounds` of two instructions each
  kStart = 2,    // the application starts; not counted
  kFeed = 3,     // the application gets one sample after another
};

struct CountingArguments {
  Counted counted = Counted::kNothing;
  std::uint32_t rounds = 0;
  outlet::Hardware hardware;
  outlet::Settings settings;
  std::uint32_t outlet = 0;   // the application's memory, kOutletBytes
  std::uint32_t samples = 0;  // std::int16_t each
  std::uint32_t count = 0;    // of samples and ticks
  std::uint32_t ticks = 0;    // of the counter, std::uint32_t for each sample
  std::uint32_t frames = 0;   // what the application sends, from kStart on
  std::uint32_t frames_capacity = 0;
  std::uint32_t frames_length = 0;  // result
};

constexpr std::uint32_t kOutletBytes = 16384;

}  // namespace gs::test
