// The reports that the follower keeps, and how its filter processes them, for grid_follower.cpp and
// onset.cpp.
#pragma once

#include <outlet/grid_follower.hpp>

namespace gs::outlet {

// Standard deviation of the process noise of the lost power in a report, as a part of scale_mw:
// outside an onset, and in it.
constexpr float kLossNoise = 1.4e-4f;
constexpr float kOnsetLossNoise = 0.85f;

constexpr float square(float x) {
  return x * x;
}

inline float loss_noise_mw2(const FollowerSettings& settings, float part) {
  return square(part * settings.scale_mw);
}

// Stops at the maximum.
inline void count_up(std::uint16_t& reports) {
  reports = static_cast<std::uint16_t>(reports < 0xFFFF ? reports + 1 : reports);
}

inline FollowedReport& at(GridFollower& f, std::uint32_t number) {
  return f.reports[number & (kFollowedReports - 1)];
}

// Processes report `number`, the first time or again.
void take(const FollowerSettings& settings, GridFollower& f, std::uint32_t number);

// Restores the filter's state before report `number`, or before the nearest one whose state was
// kept. follow_up() processes the reports from there on again.
void go_back(GridFollower& f, std::uint32_t number);

// Another filter replaces the present one. Earlier reports cannot be processed again by it.
void continue_with(GridFollower& f, const GridFilter& filter);

}  // namespace gs::outlet
