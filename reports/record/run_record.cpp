#include "fields.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <record/run_record.hpp>

namespace gsbench::record {

const char* to_string(Verdict verdict) {
  static constexpr std::array kWords = {"PASS", "INCONCLUSIVE", "FAIL", "ERROR"};
  return kWords.at(static_cast<std::size_t>(verdict));
}

std::int64_t Clock::tick_of(std::int64_t sample) const {
  return counts_ticks()
             ? sample
             : std::llround((static_cast<double>(sample) - sample_at_zero) / samples_per_tick);
}

void append(const MeasurementTrace& from, std::size_t i, MeasurementTrace& to) {
  to.tick.push_back(from.tick[i]);
  to.frequency_hz.push_back(from.frequency_hz[i]);
  to.rocof_hz_s.push_back(from.rocof_hz_s[i]);
  to.voltage_pu.push_back(from.voltage_pu[i]);
  to.validity.push_back(from.validity[i]);
}

void append(const EstimateTrace& from, std::size_t i, EstimateTrace& to) {
  to.tick.push_back(from.tick[i]);
  to.loss_mw.push_back(from.loss_mw[i]);
  to.loss_sigma_mw.push_back(from.loss_sigma_mw[i]);
  to.event_tick.push_back(from.event_tick[i]);
  to.loss_after_event_s.push_back(from.loss_after_event_s[i]);
  to.trusted.push_back(from.trusted[i]);
}

double loss_instant_s(const EstimateTrace& estimates, std::size_t i, double sample_rate_hz) {
  return static_cast<double>(estimates.event_tick[i]) / sample_rate_hz +
         static_cast<double>(estimates.loss_after_event_s[i]);
}

bool Reports::empty() const {
  return marks.empty() && sent.empty() && trace.tick.empty() && estimates.tick.empty();
}

namespace {

template <class Value>
void add(std::vector<Value>& all, const std::vector<Value>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

template <class Trace>
void add_columns(Trace& all, const Trace& more) {
  visit_fields<Trace>(more, [&](const std::string_view name, const auto& column) {
    visit_fields<Trace>(all, [&](const std::string_view other, auto& to) {
      if constexpr (std::is_same_v<decltype(to), std::decay_t<decltype(column)>&>) {
        if (name == other) {
          add(to, column);
        }
      }
    });
  });
}

// Converts the ticks of a trace and keeps what is within the run.
template <class Trace>
void place(Trace& trace, const Clock& clock, std::int64_t last_tick) {
  std::vector<std::size_t> within;
  for (std::size_t i = 0; clock.is_aligned() && i < trace.tick.size(); ++i) {
    trace.tick[i] = clock.tick_of(trace.tick[i]);
    if (trace.tick[i] >= 0 && trace.tick[i] <= last_tick) {
      within.push_back(i);
    }
  }
  visit_fields<Trace>(trace, [&](const char*, auto& column) {
    for (std::size_t i = 0; i < within.size(); ++i) {
      column[i] = column[within[i]];
    }
    column.resize(within.size());
  });
}

void place(std::vector<Mark>& marks, const Clock& clock, std::int64_t last_tick) {
  constexpr std::int64_t kOutside = -1;
  for (Mark& mark : marks) {
    if (mark.by_outlet) {
      mark.tick = clock.is_aligned() ? clock.tick_of(mark.tick) : kOutside;
    }
  }
  const auto is_outside = [&](const Mark& mark) {
    return mark.by_outlet && (mark.tick < 0 || mark.tick > last_tick);
  };
  marks.erase(std::remove_if(marks.begin(), marks.end(), is_outside), marks.end());
}

}  // namespace

void Reports::append(const Reports& later) {
  add(marks, later.marks);
  add(sent, later.sent);
  add_columns(trace, later.trace);
  add_columns(estimates, later.estimates);
}

void place_on_run_time(Reports& reports, const Clock& clock, std::int64_t last_tick) {
  if (!clock.counts_ticks()) {
    for (std::int64_t& tick : reports.estimates.event_tick) {
      tick = clock.is_aligned() ? clock.tick_of(tick) : 0;
    }
    place(reports.trace, clock, last_tick);
    place(reports.estimates, clock, last_tick);
    place(reports.marks, clock, last_tick);
  }
  // Marks of one tick keep their order, those of the outlet before those of the bench.
  std::stable_sort(reports.marks.begin(), reports.marks.end(), [](const Mark& a, const Mark& b) {
    return std::make_tuple(a.tick, !a.by_outlet) < std::make_tuple(b.tick, !b.by_outlet);
  });
}

bool is_judged(const RunRecord& run) {
  return run.fault.empty() && !run.interrupted;
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
