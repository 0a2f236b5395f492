// Self test of the arithmetic: passes a known signal through LSE and Kalman filter and computes a
// CRC over every bit of the results. A compiler, a flag or a processor whose floating-point results
// differ gives a different fingerprint.
#pragma once

#include <cstdint>

namespace gs::app {

constexpr std::uint32_t kFingerprint = 0x946A0C43u;

std::uint32_t arithmetic_fingerprint();

}  // namespace gs::app
