// Self test of the arithmetic. It passes a known signal through the LSE and the Kalman filter. The
// fingerprint is a CRC over every bit of the results. It changes if a compiler, a compiler flag or
// a processor gives different floating-point results.
#pragma once

#include <cstdint>

namespace gs::app {

constexpr std::uint32_t kFingerprint = 0x946A0C43u;

std::uint32_t arithmetic_fingerprint();

}  // namespace gs::app
