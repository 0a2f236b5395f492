// A known signal through LSE and Kalman filter, reduced to a fingerprint of every bit of the
// result: a compiler, a flag or a processor that does the arithmetic otherwise gives another one.
#pragma once

#include <cstdint>

namespace gs::app {

constexpr std::uint32_t kFingerprint = 0x946A0C43u;

std::uint32_t arithmetic_fingerprint();

}  // namespace gs::app
