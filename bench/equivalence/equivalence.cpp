#include <algorithm>
#include <cmath>
#include <optional>

#include <equivalence/equivalence.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::equivalence {
namespace {

constexpr std::uint8_t kValid = 1;
// After the start of the run the tracker settles.
constexpr double kSettle_s = 1.0;

class Sum {
 public:
  void add(double difference) {
    squares_ += difference * difference;
    largest_ = std::max(largest_, std::fabs(difference));
    ++count_;
  }
  Difference difference() const {
    return count_ == 0 ? Difference{}
                       : Difference{std::sqrt(squares_ / static_cast<double>(count_)), largest_};
  }

 private:
  double squares_ = 0.0;
  double largest_ = 0.0;
  std::size_t count_ = 0;
};

double setting(const record::OutletRecord& outlet, const char* name) {
  const auto found = outlet.settings.find(name);
  return found == outlet.settings.end() ? 0.0 : found->second;
}

class Comparison {
 public:
  explicit Comparison(const profile::Plan& plan)
      : reference_(plan.reference()),
        synthesizer_(plan.synthesizer()),
        rate_hz_(static_cast<double>(plan.stimulus.sample_rate_hz)) {}

  Row row(std::size_t run, const record::OutletRecord& outlet,
          const record::OutletRecord& first) const {
    const double tracker_delay_s = setting(outlet, "tracker_delay_s");
    const double voltage_delay_s = setting(outlet, "voltage_delay_s");
    Sum frequency;
    Sum voltage;
    Sum from_first;
    const record::MeasurementTrace& trace = outlet.reports.trace;
    for (std::size_t i = 0; i < trace.tick.size(); ++i) {
      const double t_s = static_cast<double>(trace.tick[i]) / rate_hz_;
      if (trace.validity[i] != kValid || t_s < kSettle_s) {
        continue;
      }
      const double reported_hz =
          static_cast<double>(trace.frequency_hz[i]) * (1.0 + 1e-6 * outlet.clock.drift_ppm);
      frequency.add(1e3 * (reported_hz - reference_->frequency_hz(t_s - tracker_delay_s)));
      if (const auto amplitude_pu = steady_amplitude_pu(t_s - 2.0 * voltage_delay_s, t_s)) {
        voltage.add(100.0 * (static_cast<double>(trace.voltage_pu[i]) - *amplitude_pu));
      }
      if (const auto first_hz = frequency_hz(first.reports.trace, trace.tick[i])) {
        from_first.add(1e3 * (reported_hz - *first_hz * (1.0 + 1e-6 * first.clock.drift_ppm)));
      }
    }
    return {run, outlet.id, frequency.difference(), voltage.difference(), from_first.difference()};
  }

 private:
  // The amplitude from `from_s` to `to_s` and a millisecond around, if it is constant.
  std::optional<double> steady_amplitude_pu(double from_s, double to_s) const {
    constexpr double kStep_s = 0.001;
    const std::int64_t step = std::llround(kStep_s * rate_hz_);
    const std::int64_t last = std::llround(to_s * rate_hz_) + step;
    const std::int64_t first = std::llround(from_s * rate_hz_) - step;
    const double amplitude_pu = at(first);
    for (std::int64_t tick = first; tick <= last; tick += step) {
      if (std::fabs(at(tick) - amplitude_pu) > 1e-6) {
        return std::nullopt;
      }
    }
    return amplitude_pu;
  }
  double at(std::int64_t tick) const {
    return synthesizer_.amplitude_pu(std::max<std::int64_t>(tick, 0));
  }

  // nullopt: the tick is not between two valid reports that follow each other.
  static std::optional<double> frequency_hz(const record::MeasurementTrace& trace,
                                            std::int64_t tick) {
    const auto after = std::lower_bound(trace.tick.begin(), trace.tick.end(), tick);
    if (after == trace.tick.begin() || after == trace.tick.end()) {
      return std::nullopt;
    }
    const auto i = static_cast<std::size_t>(after - trace.tick.begin());
    if (trace.validity[i - 1] != kValid || trace.validity[i] != kValid) {
      return std::nullopt;
    }
    const double part = static_cast<double>(tick - trace.tick[i - 1]) /
                        static_cast<double>(trace.tick[i] - trace.tick[i - 1]);
    return (1.0 - part) * static_cast<double>(trace.frequency_hz[i - 1]) +
           part * static_cast<double>(trace.frequency_hz[i]);
  }

  std::shared_ptr<const waveform::ReferenceSignal> reference_;
  waveform::Synthesizer synthesizer_;
  double rate_hz_;
};

}  // namespace

std::vector<Row> compare(const profile::Plan& plan, const std::vector<record::RunRecord>& runs) {
  const Comparison comparison(plan);
  const record::OutletRecord* first = nullptr;
  std::vector<Row> rows;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const record::OutletRecord& outlet : runs[run].outlets) {
      if (outlet.reports.trace.tick.empty()) {
        continue;
      }
      if (first == nullptr) {
        first = &outlet;
      }
      rows.push_back(comparison.row(run, outlet, *first));
    }
  }
  return rows;
}

}  // namespace gsbench::equivalence
