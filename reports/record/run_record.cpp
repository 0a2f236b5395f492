#include <algorithm>
#include <array>
#include <limits>

#include <record/run_record.hpp>

namespace gsbench::record {

const char* to_string(Verdict verdict) {
  static constexpr std::array kWords = {"PASS", "INCONCLUSIVE", "FAIL", "ERROR"};
  return kWords.at(static_cast<std::size_t>(verdict));
}

const MeasurementResult* find_measurement(const OutletRecord& outlet, const std::string& name) {
  for (const MeasurementResult& result : outlet.measurements) {
    if (result.name == name) {
      return &result;
    }
  }
  return nullptr;
}

double frequency_hz(const ReferenceTrace& reference, std::int64_t tick) {
  const auto after = std::upper_bound(reference.tick.begin(), reference.tick.end(), tick);
  if (after == reference.tick.begin()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto next = static_cast<std::size_t>(after - reference.tick.begin());
  const std::size_t before = next - 1;
  if (reference.tick[before] == tick) {
    return reference.frequency_hz[before];
  }
  if (after == reference.tick.end()) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const double share = static_cast<double>(tick - reference.tick[before]) /
                       static_cast<double>(reference.tick[next] - reference.tick[before]);
  return reference.frequency_hz[before] +
         share * (reference.frequency_hz[next] - reference.frequency_hz[before]);
}

}  // namespace gsbench::record
