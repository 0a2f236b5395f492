#include <outlet/conditions.hpp>

namespace gs::outlet {

bool condition_met(const Settings& settings, float nominal_hz, const Line& line) {
  if (!(line.mean_hz < nominal_hz)) {
    return false;
  }
  for (int row = 0; row < settings.condition_rows; ++row) {
    if (line.mean_hz >= settings.conditions[row].from_hz) {
      return line.slope_hz_s < settings.conditions[row].rocof_below_hz_s;
    }
  }
  return line.slope_hz_s < 0.0f;
}

}  // namespace gs::outlet
