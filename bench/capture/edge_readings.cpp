#include "dips.hpp"

#include <cmath>

namespace gsbench::capture {
namespace {

// The window of a reading in the flank of a dip ends within one window of the edge that is seen;
// another one covers the error of the first fit.
constexpr double kNear_windows = 2.0;

}  // namespace

EdgeReadings::EdgeReadings(double level, double window_samples)
    : threshold_(edge_square(level)), near_samples_(std::llround(kNear_windows * window_samples)) {
  kept_.window_samples = window_samples;
}

void EdgeReadings::add(const std::vector<std::int64_t>& sample,
                       const std::vector<float>& voltage_pu) {
  for (std::size_t i = 0; i < sample.size(); ++i) {
    add({sample[i], voltage_pu[i]});
  }
}

void EdgeReadings::add(const Reading& reading) {
  const auto volts = static_cast<double>(reading.voltage_pu);
  const bool below = volts * volts < threshold_;
  if (was_below_.value_or(below) != below) {
    for (const Reading& before : recent_) {
      keep(before);
    }
    recent_.clear();
    keeps_until_ = reading.sample + near_samples_;
  }
  was_below_ = below;
  if (reading.sample <= keeps_until_) {
    keep(reading);
    return;
  }
  recent_.push_back(reading);
  while (recent_.front().sample < reading.sample - near_samples_) {
    recent_.pop_front();
  }
}

void EdgeReadings::keep(const Reading& reading) {
  kept_.sample.push_back(reading.sample);
  kept_.voltage_pu.push_back(reading.voltage_pu);
}

VoltageTrace EdgeReadings::trace() const {
  VoltageTrace trace = kept_;
  if (!recent_.empty()) {
    trace.sample.push_back(recent_.back().sample);
    trace.voltage_pu.push_back(recent_.back().voltage_pu);
  }
  return trace;
}

}  // namespace gsbench::capture
