#include <outlet/crc32.hpp>
#include <outlet/loss_ekf.hpp>
#include <outlet/name_table.hpp>
#include <outlet/settings.hpp>

namespace gs::outlet {
namespace {

// Keeps the error of the first field that is out of range.
struct RangeCheck {
  float nominal_hz;
  SettingsError error = SettingsError::kNone;

  template <class T>
  void operator()(const Field& field, const T& value) {
    require(within(field.range, static_cast<float>(value), nominal_hz), field);
  }
  void rows(const Field& field, const ConditionRow* conditions, std::uint8_t count) {
    require(count >= 1 && count <= kMaxConditions, field);
    for (int row = 0; row < count && row < kMaxConditions; ++row) {
      require(within(kRowFrequency, conditions[row].from_hz, nominal_hz) &&
                  within(kRowRocof, conditions[row].rocof_below_hz_s, nominal_hz),
              field);
    }
  }
  void require(bool holds, const Field& field) {
    error = holds || error != SettingsError::kNone ? error : field.error;
  }
};

// Adds every integer as a 32-bit word and every float as its bits.
struct Digest {
  Crc32 crc;

  template <class T>
  void operator()(const Field&, const T& value) {
    if constexpr (std::is_floating_point_v<T>) {
      crc.add_word(value);
    } else {
      crc.add_word(std::uint32_t{value});
    }
  }
  void rows(const Field&, const ConditionRow* conditions, std::uint8_t count) {
    crc.add_word(std::uint32_t{count});
    for (int row = 0; row < count && row < kMaxConditions; ++row) {
      crc.add_word(conditions[row].from_hz);
      crc.add_word(conditions[row].rocof_below_hz_s);
    }
  }
};

// True for a stable response that stays within the series' limits over the estimator's time.
bool response_supported(const Settings& s) {
  const Response& r = s.response;
  const float tau_s =
      -kEarliestLoss_s + kReport_s * static_cast<float>(s.lse_samples + s.ekf_samples);
  const float z = r.discriminant_per_s2 * tau_s * tau_s;
  return r.discriminant_per_s2 + r.sigma_per_s * r.sigma_per_s > 0.0f &&
         z >= -kLargestSeriesArgument && z <= kLargestSeriesArgument &&
         r.sigma_per_s * tau_s <= kLargestDecay;
}

bool descending(const Settings& s) {
  for (int row = 1; row < s.condition_rows; ++row) {
    if (!(s.conditions[row].from_hz < s.conditions[row - 1].from_hz)) {
      return false;
    }
  }
  return true;
}

}  // namespace

const char* to_string(SettingsError error) {
  static constexpr const char* kNames[] = {
      "accepted",
      "setting unknown to this firmware",
      "frequency response out of range",
      "threshold or largest loss out of range",
      "accumulated power negative",
      "switching-off frequency below 80 % of nominal or above nominal",
      "load-shedding conditions missing, too many or not descending",
      "number of samples out of range",
      "event drop or departure out of range",
      "estimator settings out of range",
      "tracker settings out of range",
      "not newer than the settings in force",
      "method, threshold frequency or margin out of range",
      "delay or restoration out of range",
  };
  return name_of<kLastSettingsError>(error, kNames);
}

SettingsError validate(const Settings& s, float nominal_hz) {
  RangeCheck ranges{nominal_hz};
  visit_fields(s, ranges);
  if (ranges.error != SettingsError::kNone) {
    return ranges.error;
  }
  if (!response_supported(s)) {
    return SettingsError::kResponse;
  }
  if (!descending(s)) {
    return SettingsError::kConditions;
  }
  return s.loss_sigma_mw <= s.largest_loss_mw ? SettingsError::kNone : SettingsError::kEstimator;
}

std::uint32_t digest(const Settings& settings) {
  Digest all;
  visit_fields(settings, all);
  return all.crc.value();
}

}  // namespace gs::outlet
