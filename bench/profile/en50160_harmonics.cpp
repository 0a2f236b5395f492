#include <cmath>
#include <iterator>

#include <profile/en50160.hpp>

namespace gsbench::profile {
namespace {

// Limits of the single harmonics in public supply, % of the fundamental, from the 2nd order on;
// test pattern after EN 50160. Together they give a total distortion of 11.3 %. EN 50160 allows
// 8 %, so the pattern is worse than any compliant supply.
constexpr double kEn50160_pct[] = {2.0, 5.0, 1.0, 6.0, 0.5, 5.0, 0.5, 1.5, 0.5, 3.5, 0.5, 3.0,
                                   0.5, 0.5, 0.5, 2.0, 0.5, 1.5, 0.5, 0.5, 0.5, 1.5, 0.5, 1.5};

// Multiples of the golden angle spread the phases evenly, so that the peaks of many orders do not
// coincide.
constexpr double kGoldenAngle_deg = 137.50776405003785;

}  // namespace

std::vector<waveform::Harmonic> en50160_harmonics() {
  std::vector<waveform::Harmonic> harmonics;
  harmonics.reserve(std::size(kEn50160_pct));
  int order = 2;
  for (const double pct : kEn50160_pct) {
    harmonics.push_back(
        {static_cast<double>(order), pct, std::fmod(order * kGoldenAngle_deg, 360.0)});
    ++order;
  }
  return harmonics;
}

}  // namespace gsbench::profile
