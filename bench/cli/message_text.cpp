#include "message_text.hpp"

#include <fmt/format.h>

#include <link/version_text.hpp>

namespace gsbench::cli {
namespace {

using gs::wire::Uplink;
using gs::wire::UplinkKind;

const char* validity_text(gs::outlet::Validity validity) {
  switch (validity) {
    case gs::outlet::Validity::kInvalid:
      return "invalid";
    case gs::outlet::Validity::kValid:
      return "valid";
    case gs::outlet::Validity::kHeld:
      return "held";
  }
  return "unknown";
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

std::string details(const Uplink& m) {
  switch (m.kind) {
    case UplinkKind::kHello:
      return hello_text(m.hello);
    case UplinkKind::kSettingsAnswer:
      return fmt::format("{}; in force: version {}, digest {:08x}{}",
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
      return fmt::format("{}: {:.1f} MW lost, {:.1f} MW to shed, {} hits, estimate {}",
                         m.decision.shed ? "shed" : "hold", m.decision.loss_mw,
                         m.decision.required_mw, m.decision.hits,
                         gs::outlet::to_string(m.decision.trust));
    case UplinkKind::kRelay:
      return fmt::format("{}, cause {}", position(m.relay.closed),
                         gs::outlet::to_string(m.relay.cause));
    case UplinkKind::kAborted:
      return "the voltage went";
    case UplinkKind::kCommandAnswer:
      return fmt::format("request {}: relay {}", m.command_answer.request,
                         position(m.command_answer.closed));
    case UplinkKind::kStatus:
      return fmt::format("{} reports, relay {}, {} samples lost, {} messages bad, {} unsent",
                         m.status.reports, position(m.status.relay_closed), m.status.samples_lost,
                         m.status.messages_bad, m.status.messages_unsent);
    case UplinkKind::kSelfTest:
      return m.self_test.failed == 0
                 ? fmt::format("passed, fingerprint {:08x}", m.self_test.fingerprint)
                 : fmt::format("FAILED, parts {:#x}", m.self_test.failed);
    case UplinkKind::kEcho:
      return fmt::format("token {}", m.echo.token);
    case UplinkKind::kError:
      return fmt::format("{}, {} so far", gs::wire::to_string(m.error.code), m.error.detail);
  }
  return {};
}

}  // namespace

std::string message_text(const std::string& outlet, const Uplink& message) {
  return fmt::format("{:<20} {:>10}  {:<15} {}", outlet, message.sample,
                     gs::wire::to_string(message.kind), details(message));
}

}  // namespace gsbench::cli
