#include "sections.hpp"

#include <array>
#include <cmath>

namespace gsbench::profile {
namespace {

struct Limit {
  int order;
  double pct;  // of the fundamental
};

// Limits of each single harmonic in public supply, test pattern after EN 50160. All at once they
// make a total distortion of 11.3 %, where EN 50160 allows 8 % in all: harder than a supply that
// keeps to it can be.
constexpr std::array<Limit, 24> kEn50160 = {{
    {2, 2.0},  {3, 5.0},  {4, 1.0},  {5, 6.0},  {6, 0.5},  {7, 5.0},  {8, 0.5},  {9, 1.5},
    {10, 0.5}, {11, 3.5}, {12, 0.5}, {13, 3.0}, {14, 0.5}, {15, 0.5}, {16, 0.5}, {17, 2.0},
    {18, 0.5}, {19, 1.5}, {20, 0.5}, {21, 0.5}, {22, 0.5}, {23, 1.5}, {24, 0.5}, {25, 1.5},
}};

// Successive multiples of the golden angle never bunch: no instant of the cycle sees the peaks of
// many orders together.
constexpr double kGoldenAngleDeg = 137.50776405003785;

}  // namespace

std::vector<waveform::Harmonic> en50160_harmonics() {
  std::vector<waveform::Harmonic> harmonics;
  harmonics.reserve(kEn50160.size());
  for (const Limit& limit : kEn50160) {
    harmonics.push_back({limit.order, limit.pct, std::fmod(limit.order * kGoldenAngleDeg, 360.0)});
  }
  return harmonics;
}

}  // namespace gsbench::profile
