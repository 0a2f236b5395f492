// Onsets: changes that the filter does not explain, for grid_follower.cpp. Either the lost power
// changes, or only the phase, which the rival tests.
#pragma once

#include <outlet/grid_follower.hpp>

namespace gs::outlet {

// The most reports of an onset, and the most that are processed again: from the last kept filter
// on.
constexpr int kLongestOnset = 20;
constexpr int kMostBehind = kLongestOnset + kReportsPerKept - 1;

// Looks for an onset in the innovations of the newest reports.
bool onset_found(GridFollower& f);

// Begins an onset: the last reports are processed again, with a large process noise of the lost
// power, by the filter and by the rival.
void open(GridFollower& f);

// The voltage is found to be disturbed: its last measurements before may be wrong.
void discard_spoiled(GridFollower& f);

// The rival processes at most `reports` of those that it must process again.
void catch_up_rival(const FollowerSettings& settings, GridFollower& f, int reports);

// Processes the newest report by the rival. It may fail, which confirms the onset, or replace the
// filter.
void follow_rival(const FollowerSettings& settings, GridFollower& f, const PhaseMeasurement& m);

// True once for a change of the lost power: when it becomes significant.
bool becomes_significant(const FollowerSettings& settings, GridFollower& f);

}  // namespace gs::outlet
