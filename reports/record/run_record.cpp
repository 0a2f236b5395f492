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
    if (result.name == name) return &result;
  }
  return nullptr;
}

double frequency_hz(const TruthTrace& truth, std::int64_t tick) {
  const auto after = std::upper_bound(truth.tick.begin(), truth.tick.end(), tick);
  if (after == truth.tick.begin()) return std::numeric_limits<double>::quiet_NaN();
  const auto next = static_cast<std::size_t>(after - truth.tick.begin());
  const std::size_t before = next - 1;
  if (truth.tick[before] == tick) return truth.frequency_hz[before];
  if (after == truth.tick.end()) return std::numeric_limits<double>::quiet_NaN();
  const double share = static_cast<double>(tick - truth.tick[before]) /
                       static_cast<double>(truth.tick[next] - truth.tick[before]);
  return truth.frequency_hz[before] +
         share * (truth.frequency_hz[next] - truth.frequency_hz[before]);
}

}  // namespace gsbench::record
