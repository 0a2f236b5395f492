#include "sections.hpp"

#include <cmath>
#include <iterator>

namespace gsbench::profile {
namespace {

// Limits of each single harmonic in public supply from the 2nd on, % of the fundamental, test
// pattern after EN 50160. All at once they make a total distortion of 11.3 %, where EN 50160 allows
// 8 % in all: harder than a supply that keeps to it can be.
constexpr double kEn50160_pct[] = {2.0, 5.0, 1.0, 6.0, 0.5, 5.0, 0.5, 1.5, 0.5, 3.5, 0.5, 3.0,
                                   0.5, 0.5, 0.5, 2.0, 0.5, 1.5, 0.5, 0.5, 0.5, 1.5, 0.5, 1.5};

// Successive multiples of the golden angle never bunch: no instant of the cycle sees the peaks of
// many orders together.
constexpr double kGoldenAngle_deg = 137.50776405003785;

}  // namespace

std::vector<waveform::Harmonic> en50160_harmonics() {
  std::vector<waveform::Harmonic> harmonics;
  harmonics.reserve(std::size(kEn50160_pct));
  int order = 2;
  for (const double pct : kEn50160_pct) {
    harmonics.push_back({order, pct, std::fmod(order * kGoldenAngle_deg, 360.0)});
    ++order;
  }
  return harmonics;
}

}  // namespace gsbench::profile
