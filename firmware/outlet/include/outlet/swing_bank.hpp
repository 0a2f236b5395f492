// Detects an inter-area oscillation of 0.1 … 1 Hz that is superposed on the grid's frequency. Eight
// filters process the same measurements; each one starts at another frequency of the oscillation.
// About a third of a period after its beginning, one of the filters has converged to the
// oscillation, and the follower may continue with it.
#pragma once

#include <outlet/grid_filter.hpp>

namespace gs::outlet {

constexpr int kSwingFilters = 8;

struct SwingBank {
  GridFilter filters[kSwingFilters];
  // Sums of the normalised innovations of each filter, weighted exponentially over about five
  // measurements.
  float innovation_sums[kSwingFilters] = {};
  std::uint16_t age = 0;  // reports since the start, up to 65535
};

// An onset is rare, so that it makes a filter less likely by this, whether or not its innovations
// fit afterwards. In a filter of the bank it costs more: otherwise, an oscillation with onsets is
// likelier than a ramp of the lost power.
constexpr float kOnsetPenalty = 20.0f;
constexpr float kSwingOnsetPenalty = 32.0f;

// Starts all filters with the grid's state of `bank.filters[0]` at the time of `m`, each with an
// oscillation of another frequency that begins now.
void start(SwingBank& bank, const PhaseMeasurement& m);

// Variances that a step adds to p, MW²: in general, and when p changes.
struct LossNoise {
  float steady = 0.0f;
  float onset = 0.0f;
};

// Measurements in which p may have changed before an onset is found.
constexpr int kOnsetMeasurements = 7;

// Moves filter `number`, 0 … kSwingFilters − 1, by one report. To spread the work, the filters may
// be moved one at a time, in ascending order. All must be moved before the next report. A filter
// whose innovations do not fit assumes that p has changed, by open_loss().
void follow(const GridStep& step, SwingBank& bank, int number, const LossNoise& noise,
            const PhaseMeasurement& m);

const GridFilter& likeliest(const SwingBank& bank);

// The likeliest filter, if its oscillation is established; otherwise nullptr. It is established if
// its amplitude is between 12 mHz (and six standard deviations) and 80 mHz, 0.35 to 0.9 of its
// period has passed since the start (what takes longer is a ramp of the lost power), and it is
// likelier by 32 than the filter without an oscillation, whose likelihood is given. A bank that
// starts at an onset has a lead: it has neither paid kOnsetPenalty nor processed the reports before
// the onset was found.
const GridFilter* established(const SwingBank& bank, float likelihood_without);

}  // namespace gs::outlet
