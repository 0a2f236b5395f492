#include "message_text.hpp"

#include <array>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <link/version_text.hpp>

namespace gsbench::cli {
namespace {

using gs::wire::Uplink;
using gs::wire::UplinkKind;
using Json = nlohmann::ordered_json;

const char* validity_text(gs::outlet::Validity validity) {
  static constexpr std::array kNames = {"invalid", "valid", "held"};
  const auto index = static_cast<std::size_t>(validity);
  return index < kNames.size() ? kNames[index] : "unknown";
}

const char* position(bool closed) {
  return closed ? "closed" : "open";
}

std::string hello_text(const gs::wire::Hello& hello) {
  return fmt::format("board {}, firmware {} build {:08x}, {} Hz samples of {} Hz mains, {}",
                     hello.board, link::version_text(hello.firmware_version), hello.build,
                     hello.sample_rate_hz, hello.nominal_hz,
                     hello.settings_version == 0
                         ? std::string("no settings")
                         : fmt::format("settings version {}", hello.settings_version));
}

const char* phase_text(gs::outlet::Phase phase) {
  static constexpr std::array kNames = {"quiet", "estimating", "cooling"};
  const auto index = static_cast<std::size_t>(phase);
  return index < kNames.size() ? kNames[index] : "unknown";
}

std::string hex(std::uint32_t number) {
  return fmt::format("{:08x}", number);
}

// The digits that the float has; as a double, 50.1f would have 16 of them.
Json number(float value) {
  return std::isfinite(value) ? Json(std::strtod(fmt::format("{}", value).c_str(), nullptr))
                              : Json();
}

Json hello_fields(const gs::wire::Hello& hello) {
  Json fields = {{"protocol", hello.protocol_version}};
  if (hello.protocol_version != gs::wire::kProtocolVersion) {
    return fields;  // the other fields of another version cannot be read
  }
  fields.update({{"board", hello.board},
                 {"instance", hello.instance},
                 {"firmware", link::version_text(hello.firmware_version)},
                 {"build", hex(hello.build)},
                 {"sample_rate_hz", hello.sample_rate_hz},
                 {"nominal_hz", hello.nominal_hz},
                 {"tracker_delay_s", number(hello.tracker_delay_s)},
                 {"voltage_delay_s", number(hello.voltage_delay_s)},
                 {"settings_version", hello.settings_version},
                 {"settings_digest", hex(hello.settings_digest)},
                 {"keeps_settings", (hello.capabilities & gs::wire::kKeepsSettings) != 0},
                 {"has_watchdog", (hello.capabilities & gs::wire::kHasWatchdog) != 0},
                 {"session", hello.session},
                 {"next_number", hello.next_number}});
  return fields;
}

Json status_fields(const gs::wire::Status& status) {
  return {{"reports", status.reports},
          {"relay", position(status.relay_closed)},
          {"cause", gs::outlet::to_string(status.cause)},
          {"phase", phase_text(status.phase)},
          {"samples_lost", status.samples_lost},
          {"messages_bad", status.messages_bad},
          {"messages_unsent", status.messages_unsent},
          {"messages_dropped", status.messages_dropped}};
}

Json decision_fields(const gs::wire::DecisionMessage& decision) {
  return {{"shed", decision.shed},
          {"loss_mw", number(decision.loss_mw)},
          {"loss_sigma_mw", number(decision.loss_sigma_mw)},
          {"nadir_hz", number(decision.nadir_hz)},
          {"required_mw", number(decision.required_mw)},
          {"shed_before_mw", number(decision.shed_before_mw)},
          {"hits", decision.hits},
          {"estimate", gs::outlet::to_string(decision.trust)}};
}

}  // namespace

std::string details(const Uplink& m) {
  switch (m.kind) {
    case UplinkKind::kHello:
      return hello_text(m.hello);
    case UplinkKind::kSettingsAnswer:
      return fmt::format("{}; accepted last: version {}, digest {:08x}{}",
                         gs::outlet::to_string(m.settings_answer.error), m.settings_answer.version,
                         m.settings_answer.digest, m.settings_answer.kept ? ", kept" : "");
    case UplinkKind::kMeasurement:
      return fmt::format("{:9.4f} Hz {:+8.3f} Hz/s {:6.4f} pu {}", m.measurement.frequency_hz,
                         m.measurement.rocof_hz_s, m.measurement.voltage_pu,
                         validity_text(m.measurement.validity));
    case UplinkKind::kEvent:
      return fmt::format("from {:.4f} Hz, {:+.4f} Hz/s", m.event.baseline_hz,
                         m.event.baseline_rocof_hz_s);
    case UplinkKind::kLse:
      return fmt::format("{:.1f} MW", m.lse.loss_mw);
    case UplinkKind::kEstimate:
      return fmt::format("{:.1f} ± {:.1f} MW, {}", m.estimate.loss_mw, m.estimate.loss_sigma_mw,
                         gs::outlet::to_string(m.estimate.trust));
    case UplinkKind::kDecision:
      return fmt::format(
          "{}: {:.1f} ± {:.1f} MW lost, nadir {:.3f} Hz, {:.1f} MW to shed after {:.1f} MW before, "
          "{} hits, estimate {}",
          m.decision.shed ? "shed" : "hold", m.decision.loss_mw, m.decision.loss_sigma_mw,
          m.decision.nadir_hz, m.decision.required_mw, m.decision.shed_before_mw, m.decision.hits,
          gs::outlet::to_string(m.decision.trust));
    case UplinkKind::kRelay:
      return fmt::format("{}, cause {}", position(m.relay.closed),
                         gs::outlet::to_string(m.relay.cause));
    case UplinkKind::kAborted:
      return "the voltage was lost";
    case UplinkKind::kCommandAnswer:
      return fmt::format("request {} of session {}: relay {}", m.command_answer.request,
                         m.command_answer.session, position(m.command_answer.closed));
    case UplinkKind::kStatus:
      return fmt::format(
          "{} reports, relay {}, cause {}, {}, {} samples lost, {} messages bad, {} unsent, {} "
          "dropped",
          m.status.reports, position(m.status.relay_closed), gs::outlet::to_string(m.status.cause),
          phase_text(m.status.phase), m.status.samples_lost, m.status.messages_bad,
          m.status.messages_unsent, m.status.messages_dropped);
    case UplinkKind::kSelfTest:
      return m.self_test.failed == 0
                 ? fmt::format("passed, fingerprint {:08x}", m.self_test.fingerprint)
                 : fmt::format("FAILED, parts {:#x}", m.self_test.failed);
    case UplinkKind::kEcho:
      return fmt::format("token {}", m.echo.token);
    case UplinkKind::kError:
      return m.error.code == gs::wire::ErrorCode::kUnknownSession ||
                     m.error.code == gs::wire::ErrorCode::kOtherStart
                 ? fmt::format("{}, number {}", gs::wire::to_string(m.error.code), m.error.detail)
                 : fmt::format("{}, {} so far", gs::wire::to_string(m.error.code), m.error.detail);
  }
  return {};
}

Json fields_of(const Uplink& m) {
  switch (m.kind) {
    case UplinkKind::kHello:
      return hello_fields(m.hello);
    case UplinkKind::kSettingsAnswer:
      return {{"answer", gs::outlet::to_string(m.settings_answer.error)},
              {"settings_version", m.settings_answer.version},
              {"settings_digest", hex(m.settings_answer.digest)},
              {"kept", m.settings_answer.kept}};
    case UplinkKind::kMeasurement:
      return {{"frequency_hz", number(m.measurement.frequency_hz)},
              {"rocof_hz_s", number(m.measurement.rocof_hz_s)},
              {"voltage_pu", number(m.measurement.voltage_pu)},
              {"validity", validity_text(m.measurement.validity)}};
    case UplinkKind::kEvent:
      return {{"baseline_hz", number(m.event.baseline_hz)},
              {"baseline_rocof_hz_s", number(m.event.baseline_rocof_hz_s)}};
    case UplinkKind::kLse:
      return {{"loss_mw", number(m.lse.loss_mw)}};
    case UplinkKind::kEstimate:
      return {{"loss_mw", number(m.estimate.loss_mw)},
              {"loss_sigma_mw", number(m.estimate.loss_sigma_mw)},
              {"loss_instant_s", number(m.estimate.loss_instant_s)},
              {"estimate", gs::outlet::to_string(m.estimate.trust)}};
    case UplinkKind::kDecision:
      return decision_fields(m.decision);
    case UplinkKind::kRelay:
      return {{"relay", position(m.relay.closed)}, {"cause", gs::outlet::to_string(m.relay.cause)}};
    case UplinkKind::kAborted:
      return Json::object();
    case UplinkKind::kCommandAnswer:
      return {{"request", m.command_answer.request},
              {"relay", position(m.command_answer.closed)},
              {"session", m.command_answer.session}};
    case UplinkKind::kStatus:
      return status_fields(m.status);
    case UplinkKind::kSelfTest:
      return {{"failed", m.self_test.failed}, {"fingerprint", hex(m.self_test.fingerprint)}};
    case UplinkKind::kEcho:
      return {{"token", m.echo.token}};
    case UplinkKind::kError:
      return {{"error", gs::wire::to_string(m.error.code)}, {"detail", m.error.detail}};
  }
  return Json::object();
}

Json as_json(const link::OutletPresence& outlet, bool answered) {
  Json json = Json::object();
  if (outlet.id != outlet.where) {
    json["id"] = outlet.id;
  }
  json["where"] = outlet.where;
  json["fault"] = outlet.fault;
  if (answered) {
    json.update(hello_fields(outlet.hello));
  }
  return json;
}

}  // namespace gsbench::cli
