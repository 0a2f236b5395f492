// The fields of every message in their order on the wire. Encoder and decoder both use these lists,
// so that they cannot disagree.
//
// A visitor has
//   visit(field)                                           for bool, std::uint8_t … std::uint32_t,
//                                                          std::int32_t, float and char arrays
//   visit.choice(field, last) or (field, last, first)      for enumerations from 0 or from `first`
//   visit.settings(message)                                for settings, one map
#pragma once

#include <wire/messages.hpp>

namespace gs::wire {

template <class V, class... Fields>
void visit_all(V& visit, Fields&... fields) {
  (visit(fields), ...);
}

// `U`, `D`: the message type, or its const form.
template <class U, class V>
void hello_fields(U& message, V& visit) {
  auto& m = message.hello;
  visit_all(visit, m.protocol_version, m.id);
  // The other fields of another version's hello are unknown.
  if (m.protocol_version != kProtocolVersion) {
    return;
  }
  visit_all(visit, message.start_number, m.board, m.instance, m.firmware_version, m.build,
            m.capabilities, m.sample_rate_hz, m.nominal_hz, m.tracker_delay_s, m.voltage_delay_s,
            m.settings_version, m.settings_digest, m.session, m.next_number);
}

template <class M, class V>
void status_fields(M& m, V& visit) {
  visit_all(visit, m.reports, m.relay_closed);
  visit.choice(m.cause, outlet::Cause::kCommand);
  visit.choice(m.phase, outlet::Phase::kCooling);
  visit_all(visit, m.samples_lost, m.messages_bad, m.messages_unsent, m.messages_dropped);
}

// The rest of the head: what comes after kind and sequence. The head of hello is the same in every
// version, so that its start number is among its fields.
template <class U, class V>
void uplink_head(U& m, V& visit) {
  visit(m.sample);
  if (m.kind != UplinkKind::kHello) {
    visit(m.start_number);
  }
}

template <class D, class V>
void downlink_head(D& m, V& visit) {
  visit(m.session);
}

template <class U, class V>
void uplink_fields(U& m, V& visit) {
  switch (m.kind) {
    case UplinkKind::kHello:
      return hello_fields(m, visit);
    case UplinkKind::kSettingsAnswer:
      visit.choice(m.settings_answer.error, outlet::kLastSettingsError);
      return visit_all(visit, m.settings_answer.version, m.settings_answer.digest,
                       m.settings_answer.kept);
    case UplinkKind::kMeasurement:
      visit_all(visit, m.measurement.frequency_hz, m.measurement.rocof_hz_s,
                m.measurement.voltage_pu);
      return visit.choice(m.measurement.validity, outlet::Validity::kHeld);
    case UplinkKind::kEvent:
      return visit_all(visit, m.event.baseline_hz, m.event.baseline_rocof_hz_s);
    case UplinkKind::kLse:
      return visit(m.lse.loss_mw);
    case UplinkKind::kEstimate:
      visit_all(visit, m.estimate.loss_mw, m.estimate.loss_sigma_mw, m.estimate.loss_instant_s);
      return visit.choice(m.estimate.trust, outlet::kLastTrust);
    case UplinkKind::kDecision:
      visit_all(visit, m.decision.loss_mw, m.decision.loss_sigma_mw, m.decision.nadir_hz,
                m.decision.required_mw, m.decision.shed_before_mw, m.decision.hits);
      visit.choice(m.decision.trust, outlet::kLastTrust);
      return visit(m.decision.shed);
    case UplinkKind::kRelay:
      visit(m.relay.closed);
      return visit.choice(m.relay.cause, outlet::Cause::kCommand);
    case UplinkKind::kAborted:
      return;
    case UplinkKind::kCommandAnswer:
      return visit_all(visit, m.command_answer.request, m.command_answer.closed,
                       m.command_answer.session);
    case UplinkKind::kStatus:
      return status_fields(m.status, visit);
    case UplinkKind::kSelfTest:
      return visit_all(visit, m.self_test.failed, m.self_test.fingerprint);
    case UplinkKind::kEcho:
      return visit(m.echo.token);
    case UplinkKind::kError:
      visit.choice(m.error.code, kLastErrorCode, kFirstErrorCode);
      return visit(m.error.detail);
  }
}

template <class D, class V>
void downlink_fields(D& m, V& visit) {
  switch (m.kind) {
    case DownlinkKind::kSettings:
      return visit.settings(m);
    case DownlinkKind::kCommand:
      return visit_all(visit, m.request, m.close_relay, m.start_number);
    case DownlinkKind::kIdentify:
    case DownlinkKind::kAskStatus:
    case DownlinkKind::kAskSelfTest:
      return;
    case DownlinkKind::kPing:
      return visit(m.token);
  }
}

}  // namespace gs::wire
