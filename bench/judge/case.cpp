#include <algorithm>

#include <grid/sfr_model.hpp>
#include <judge/case.hpp>
#include <waveform/synthesizer.hpp>

namespace gsbench::judge {
namespace {

// Edges that follow each other within this time count as one change with its bounces.
constexpr double kBounceWindow_ms = 10.0;

template <class Predicate>
const record::Mark* find_mark(const record::OutletRecord& outlet, std::int64_t from_tick,
                              Predicate matches) {
  const auto found = std::find_if(
      outlet.reports.marks.begin(), outlet.reports.marks.end(),
      [&](const record::Mark& mark) { return mark.tick >= from_tick && matches(mark); });
  return found == outlet.reports.marks.end() ? nullptr : &*found;
}

}  // namespace

double Case::seconds(std::int64_t tick) const {
  return static_cast<double>(tick) / static_cast<double>(plan.stimulus.sample_rate_hz);
}

double Case::milliseconds_between(std::int64_t from_tick, std::int64_t to_tick) const {
  return 1e3 * seconds(to_tick - from_tick);
}

double Case::tracker_delay_s() const {
  const auto setting = outlet.settings.find("tracker_delay_s");
  return setting == outlet.settings.end() ? 0.0 : setting->second;
}

std::optional<std::int64_t> Case::first_loss_tick() const {
  std::optional<std::int64_t> first;
  for (const grid::PowerChange& loss : plan.stimulus.losses) {
    const std::int64_t tick = waveform::tick_at(loss.at_s, plan.stimulus.sample_rate_hz);
    if (loss.power_mw > 0.0 && (!first || tick < *first)) {
      first = tick;
    }
  }
  return first;
}

double Case::lost_mw(std::int64_t tick) const {
  double sum_mw = 0.0;
  for (const grid::PowerChange& loss : plan.stimulus.losses) {
    if (waveform::tick_at(loss.at_s, plan.stimulus.sample_rate_hz) <= tick) {
      sum_mw += loss.changed_mw(std::max(seconds(tick) - loss.at_s, 0.0));
    }
  }
  return sum_mw;
}

double Case::lost_before_mw() const {
  const double deviation_hz = plan.stimulus.initial_deviation_hz;
  return deviation_hz == 0.0 ? 0.0 : -deviation_hz / grid::SfrModel(plan.grid).gain_hz_per_mw();
}

double Case::reference_voltage_pu(double t_s) const {
  double voltage_pu = reference.voltage_pu(t_s);
  for (const waveform::AmplitudeStep& step : plan.stimulus.signal.amplitude_steps) {
    if (t_s >= step.at_s && t_s < step.at_s + step.duration_s) {
      voltage_pu *= step.level_pct / 100.0;
    }
  }
  return voltage_pu;
}

const record::Mark* Case::first_mark(const std::string& kind, std::int64_t from_tick) const {
  return find_mark(outlet, from_tick, [&](const record::Mark& mark) { return mark.kind == kind; });
}

const record::Mark* Case::first_reported_opening(std::int64_t from_tick) const {
  return find_mark(outlet, from_tick, [](const record::Mark& mark) {
    return mark.kind == "relay.reported" && mark.value < 0.5;
  });
}

Contact contact(const Case& c) {
  std::vector<ContactChange> bursts;
  std::int64_t last_tick = 0;
  for (const record::Mark& mark : c.outlet.reports.marks) {
    if (mark.kind != "relay.sense") {
      continue;
    }
    const bool closed = mark.value > 0.5;
    if (!bursts.empty() && c.milliseconds_between(last_tick, mark.tick) <= kBounceWindow_ms) {
      bursts.back().closed = closed;
      ++bursts.back().edges;
    } else {
      bursts.push_back({mark.tick, closed, 1});
    }
    last_tick = mark.tick;
  }
  Contact contact;
  for (const ContactChange& burst : bursts) {
    if (burst.closed == contact.closed) {
      contact.idle_edges += burst.edges;
    } else {
      contact.changes.push_back(burst);
      contact.closed = burst.closed;
    }
  }
  return contact;
}

}  // namespace gsbench::judge
