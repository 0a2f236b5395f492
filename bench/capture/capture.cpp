#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include <capture/capture.hpp>

namespace gsbench::capture {

using gs::outlet::Trust;
using gs::wire::UplinkKind;

namespace {

// Why an outlet sheds, or does not.
std::string reason(const gs::wire::DecisionMessage& decision) {
  if (decision.shed) {
    return "shed";
  }
  if (decision.trust != Trust::kTrusted) {
    return std::string("hold; estimate ") + to_string(decision.trust);
  }
  return decision.required_mw > 0.0F ? "hold; less important load suffices"
                                     : "hold; nothing has to be shed";
}

}  // namespace

void Capture::add(const std::vector<link::Received>& messages) {
  for (const link::Received& received : messages) {
    add(tracks_[received.id], received.message);
  }
}

void Capture::add(Track& track, const gs::wire::Uplink& message) {
  std::vector<record::Mark>& marks = track.marks;
  const auto tick = static_cast<std::int64_t>(message.sample);
  switch (message.kind) {
    case UplinkKind::kHello:
    case UplinkKind::kCommandAnswer:
    case UplinkKind::kStatus:
    case UplinkKind::kEcho:
    case UplinkKind::kError:
      break;
    case UplinkKind::kSelfTest:
      track.self_test_failed = message.self_test.failed;
      break;
    case UplinkKind::kSettingsAnswer: {
      const gs::wire::SettingsAnswer& answer = message.settings_answer;
      if (track.settings_answers.empty()) {
        track.settings_digest = fmt::format("{:08x}", answer.digest);
      }
      track.settings_answers.push_back(answer.error);
      break;
    }
    case UplinkKind::kMeasurement:
      track.measurements.push_back({tick, message.measurement});
      break;
    case UplinkKind::kEvent:
      track.newest_event_sample = tick;
      marks.push_back({tick, "event", static_cast<double>(message.event.baseline_hz),
                       "frequency before it, Hz"});
      break;
    case UplinkKind::kLse:
      marks.push_back({tick, "lse", static_cast<double>(message.lse.loss_mw), "MW"});
      break;
    case UplinkKind::kEstimate:
      track.estimates.push_back({tick, track.newest_event_sample, message.estimate});
      break;
    case UplinkKind::kDecision: {
      const gs::wire::DecisionMessage& decision = message.decision;
      marks.push_back(
          {tick, "decision", static_cast<double>(decision.required_mw), reason(decision)});
      marks.push_back({tick, "decision.loss", static_cast<double>(decision.loss_mw), "MW"});
      marks.push_back({tick, "decision.sigma", static_cast<double>(decision.loss_sigma_mw), "MW"});
      if (std::isfinite(decision.nadir_hz)) {
        marks.push_back({tick, "decision.nadir", static_cast<double>(decision.nadir_hz), "Hz"});
      }
      marks.push_back(
          {tick, "decision.shed_before", static_cast<double>(decision.shed_before_mw), "MW"});
      marks.push_back({tick, "decision.hits", static_cast<double>(decision.hits), ""});
      marks.push_back({tick, "decision.trust", decision.trust == Trust::kTrusted ? 1.0 : 0.0,
                       to_string(decision.trust)});
      break;
    }
    case UplinkKind::kRelay:
      marks.push_back({tick, "relay.reported", message.relay.closed ? 1.0 : 0.0,
                       to_string(message.relay.cause)});
      break;
    case UplinkKind::kAborted:
      marks.push_back({tick, "aborted", 0.0, "voltage lost"});
      break;
  }
}

void Capture::add_edge(const std::string& id, std::int64_t tick, bool closed) {
  tracks_[id].bench_marks.push_back(
      {tick, "relay.sense", closed ? 1.0 : 0.0, closed ? "closed" : "open"});
}

void Capture::add_command(const std::string& id, std::int64_t tick, bool close) {
  tracks_[id].bench_marks.push_back(
      {tick, "command", close ? 1.0 : 0.0, close ? "switch on" : "switch off"});
}

void Capture::add_settings(const std::string& id, std::int64_t tick, std::uint32_t version,
                           const std::string& changes) {
  tracks_[id].bench_marks.push_back(
      {tick, "settings", static_cast<double>(version), changes.empty() ? "unchanged" : changes});
}

const Capture::Track& Capture::track(const std::string& id) const {
  static const Track kEmpty;
  const auto found = tracks_.find(id);
  return found != tracks_.end() ? found->second : kEmpty;
}

std::uint64_t Capture::last_report_sample(const std::string& id) const {
  const std::vector<Track::Measurement>& all = track(id).measurements;
  return all.empty() ? 0 : static_cast<std::uint64_t>(all.back().sample);
}

VoltageTrace Capture::voltage_trace(const std::string& id) const {
  VoltageTrace voltage;
  for (const Track::Measurement& measurement : track(id).measurements) {
    voltage.sample.push_back(static_cast<std::uint64_t>(measurement.sample));
    voltage.voltage_pu.push_back(measurement.message.voltage_pu);
  }
  return voltage;
}

void Capture::move_into(record::OutletRecord& record, const OutletClock& clock,
                        std::int64_t last_tick) {
  Track track = std::move(tracks_[record.id]);
  tracks_.erase(record.id);
  const auto to_tick = [&](std::int64_t sample) {
    return clock.tick_of(static_cast<std::uint64_t>(sample));
  };
  const auto in_run = [&](std::int64_t tick) { return tick >= 0 && tick <= last_tick; };
  for (const auto& [sample, message] : track.measurements) {
    const std::int64_t tick = to_tick(sample);
    if (in_run(tick)) {
      record.trace.tick.push_back(tick);
      record.trace.frequency_hz.push_back(message.frequency_hz);
      record.trace.rocof_hz_s.push_back(message.rocof_hz_s);
      record.trace.voltage_pu.push_back(message.voltage_pu);
      record.trace.validity.push_back(static_cast<std::uint8_t>(message.validity));
    }
  }
  for (const auto& [sample, event_sample, message] : track.estimates) {
    const std::int64_t tick = to_tick(sample);
    if (in_run(tick)) {
      const double event_s = static_cast<double>(to_tick(event_sample)) / sample_rate_hz_;
      record.estimates.tick.push_back(tick);
      record.estimates.loss_mw.push_back(message.loss_mw);
      record.estimates.loss_sigma_mw.push_back(message.loss_sigma_mw);
      record.estimates.t_x_s.push_back(
          static_cast<float>(event_s + static_cast<double>(message.loss_instant_s)));
      record.estimates.trusted.push_back(message.trust == Trust::kTrusted ? 1 : 0);
    }
  }
  std::vector<record::Mark>& marks = track.marks;
  for (record::Mark& mark : marks) {
    mark.tick = to_tick(mark.tick);
  }
  marks.insert(marks.end(), track.bench_marks.begin(), track.bench_marks.end());
  // Stable: marks of one tick keep their order, the outlet's reports before those of the bench.
  std::stable_sort(marks.begin(), marks.end(),
                   [](const record::Mark& a, const record::Mark& b) { return a.tick < b.tick; });
  std::copy_if(marks.begin(), marks.end(), std::back_inserter(record.marks),
               [&](const record::Mark& mark) { return in_run(mark.tick); });
  record.settings_digest = track.settings_digest;
}

}  // namespace gsbench::capture
