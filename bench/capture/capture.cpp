#include <cmath>
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

void append(record::MeasurementTrace& trace, std::int64_t sample,
            const gs::wire::MeasurementMessage& message) {
  trace.tick.push_back(sample);
  trace.frequency_hz.push_back(message.frequency_hz);
  trace.rocof_hz_s.push_back(message.rocof_hz_s);
  trace.voltage_pu.push_back(message.voltage_pu);
  trace.validity.push_back(static_cast<std::uint8_t>(message.validity));
}

void append(record::EstimateTrace& estimates, std::int64_t sample, std::int64_t event_sample,
            const gs::wire::EstimateMessage& message) {
  estimates.tick.push_back(sample);
  estimates.loss_mw.push_back(message.loss_mw);
  estimates.loss_sigma_mw.push_back(message.loss_sigma_mw);
  estimates.event_tick.push_back(event_sample);
  estimates.loss_after_event_s.push_back(message.loss_instant_s);
  estimates.trusted.push_back(message.trust == Trust::kTrusted ? 1 : 0);
}

}  // namespace

void Capture::add(const std::vector<link::Received>& messages) {
  for (const link::Received& received : messages) {
    add(tracks_[received.id], received.message);
  }
}

void Capture::add(Track& track, const gs::wire::Uplink& message) {
  const auto tick = static_cast<std::int64_t>(message.sample);
  const auto mark = [&](const char* kind, double value, const std::string& text) {
    track.reports.marks.push_back({tick, kind, value, text, true});
  };
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
      const std::string digest = fmt::format("{:08x}", answer.digest);
      if (track.settings_answers.empty()) {
        track.settings_digest = digest;
      } else {
        mark("settings.answer", static_cast<double>(answer.version),
             answer.error == gs::outlet::SettingsError::kNone
                 ? "accepted, digest " + digest
                 : std::string("refused: ") + gs::outlet::to_string(answer.error));
      }
      track.settings_answers.push_back(answer.error);
      break;
    }
    case UplinkKind::kMeasurement:
      append(track.reports.trace, tick, message.measurement);
      track.newest_sample = tick;
      break;
    case UplinkKind::kEvent:
      track.newest_event_sample = tick;
      mark("event", static_cast<double>(message.event.baseline_hz), "frequency before it, Hz");
      break;
    case UplinkKind::kLse:
      mark("lse", static_cast<double>(message.lse.loss_mw), "MW");
      break;
    case UplinkKind::kEstimate:
      append(track.reports.estimates, tick, track.newest_event_sample, message.estimate);
      break;
    case UplinkKind::kDecision: {
      const gs::wire::DecisionMessage& decision = message.decision;
      mark("decision", static_cast<double>(decision.required_mw), reason(decision));
      mark("decision.loss", static_cast<double>(decision.loss_mw), "MW");
      mark("decision.sigma", static_cast<double>(decision.loss_sigma_mw), "MW");
      if (std::isfinite(decision.nadir_hz)) {
        mark("decision.nadir", static_cast<double>(decision.nadir_hz), "Hz");
      }
      mark("decision.shed_before", static_cast<double>(decision.shed_before_mw), "MW");
      mark("decision.hits", static_cast<double>(decision.hits), "");
      mark("decision.trust", decision.trust == Trust::kTrusted ? 1.0 : 0.0,
           to_string(decision.trust));
      break;
    }
    case UplinkKind::kRelay:
      mark("relay.reported", message.relay.closed ? 1.0 : 0.0, to_string(message.relay.cause));
      break;
    case UplinkKind::kAborted:
      mark("aborted", 0.0, "voltage lost");
      break;
  }
}

void Capture::add_edge(const std::string& id, std::int64_t tick, bool closed) {
  tracks_[id].reports.marks.push_back(
      {tick, "relay.sense", closed ? 1.0 : 0.0, closed ? "closed" : "open"});
}

void Capture::add_command(const std::string& id, std::int64_t tick, bool close) {
  tracks_[id].reports.marks.push_back(
      {tick, "command", close ? 1.0 : 0.0, close ? "switch on" : "switch off"});
}

void Capture::add_settings(const std::string& id, std::int64_t tick, std::uint32_t version,
                           const std::string& changes) {
  tracks_[id].reports.marks.push_back(
      {tick, "settings", static_cast<double>(version), changes.empty() ? "unchanged" : changes});
}

void Capture::add_sent(const std::string& id, record::Sent sent) {
  tracks_[id].reports.sent.push_back(std::move(sent));
}

const Capture::Track& Capture::track(const std::string& id) const {
  static const Track kEmpty;
  const auto found = tracks_.find(id);
  return found != tracks_.end() ? found->second : kEmpty;
}

record::Reports Capture::take(const std::string& id) {
  const auto found = tracks_.find(id);
  return found != tracks_.end() ? std::exchange(found->second.reports, {}) : record::Reports{};
}

}  // namespace gsbench::capture
