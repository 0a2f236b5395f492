#include <node/node.hpp>

namespace gs::node {

using wire::UplinkKind;

bool Node::start(const outlet::Hardware& hardware, Outbox& outbox) {
  state_ = outlet::State{};
  samples_ = 0;
  started_ = outlet::configure(hardware, config_);
  if (!started_) {
    return false;
  }
  wire::Uplink hello = message(UplinkKind::kHello);
  hello.hello.firmware_version = kFirmwareVersion;
  hello.hello.sample_rate_hz = hardware.sample_rate_hz;
  hello.hello.nominal_hz = hardware.nominal_hz;
  hello.hello.tracker_delay_s = outlet::kFrontEndDelayS;
  outbox.put(hello);
  return true;
}

void Node::feed(const std::int16_t* samples, std::size_t count, Outbox& outbox) {
  if (!started_) {
    return;
  }
  std::size_t done = 0;
  while (done < count) {
    outlet::Report report;
    bool ready = false;
    const std::size_t taken =
        outlet::step(config_, state_, samples + done, count - done, report, ready);
    done += taken;
    samples_ += taken;
    if (ready) {
      tell(report, outbox);
    }
  }
}

void Node::receive(const wire::Downlink& downlink, Outbox& outbox) {
  if (!started_) {
    return;
  }
  switch (downlink.kind) {
    case wire::DownlinkKind::kSettings:
      take_settings(downlink.settings, outbox);
      break;
    case wire::DownlinkKind::kCommand:
      if (outlet::command(state_, downlink.close_relay)) {
        outbox.put(relay_message());
      }
      break;
  }
}

void Node::take_settings(const outlet::Settings& settings, Outbox& outbox) {
  wire::Uplink answer = message(UplinkKind::kSettingsAnswer);
  answer.settings_answer.error = outlet::apply(config_, state_, settings);
  answer.settings_answer.version = config_.settings.version;
  answer.settings_answer.digest = outlet::digest(config_.settings);
  outbox.put(answer);
}

void Node::tell(const outlet::Report& report, Outbox& outbox) const {
  wire::Uplink measurement = message(UplinkKind::kMeasurement);
  measurement.measurement = {report.measurement.frequency_hz, report.measurement.rocof_hz_s,
                             report.measurement.voltage_pu, report.measurement.validity};
  outbox.put(measurement);
  if ((report.happened & outlet::kEvent) != 0) {
    wire::Uplink event = message(UplinkKind::kEvent);
    event.event = {report.baseline.frequency_hz, report.baseline.rocof_hz_s};
    outbox.put(event);
  }
  if ((report.happened & outlet::kLse) != 0) {
    wire::Uplink lse = message(UplinkKind::kLse);
    lse.lse = {report.lse_loss_mw};
    outbox.put(lse);
  }
  if ((report.happened & outlet::kEstimate) != 0) {
    wire::Uplink estimate = message(UplinkKind::kEstimate);
    estimate.estimate = {report.loss_mw, report.loss_sigma_mw, report.loss_instant_s, report.trust};
    outbox.put(estimate);
  }
  if ((report.happened & outlet::kDecision) != 0) {
    wire::Uplink decision = message(UplinkKind::kDecision);
    const bool shed =
        (report.happened & outlet::kRelay) != 0 && report.cause == outlet::Cause::kLoss;
    decision.decision = {report.loss_mw, report.required_mw, report.hits, report.trust, shed};
    outbox.put(decision);
  }
  if ((report.happened & outlet::kRelay) != 0) {
    outbox.put(relay_message());
  }
  if ((report.happened & outlet::kAborted) != 0) {
    outbox.put(message(UplinkKind::kAborted));
  }
}

wire::Uplink Node::message(UplinkKind kind) const {
  wire::Uplink message;
  message.kind = kind;
  message.sample = samples_;
  return message;
}

wire::Uplink Node::relay_message() const {
  wire::Uplink relay = message(UplinkKind::kRelay);
  relay.relay = {state_.relay_closed, state_.cause};
  return relay;
}

}  // namespace gs::node
