#include <app/application.hpp>
#include <app/self_test.hpp>

namespace gs::app {

using wire::UplinkKind;

bool Application::start(const outlet::Hardware& hardware, const Identity& identity,
                        SettingsStorage* storage, Outbox& outbox, const outlet::Settings* kept) {
  outlet::reset(state_);
  counts_ = Counts{};
  kept_ = false;
  started_ = outlet::configure(hardware, config_);
  if (!started_) {
    return false;
  }
  identity_ = identity;
  storage_ = storage;
  const bool refused = kept != nullptr && !restore(*kept);
  send_hello(outbox);
  if (refused) {
    note(wire::ErrorCode::kSettingsStorage, outbox);
  }
  return true;
}

bool Application::restore(const outlet::Settings& settings) {
  kept_ = started_ && outlet::apply(config_, state_, settings) == outlet::SettingsError::kNone;
  return kept_;
}

void Application::feed(const std::int16_t* samples, std::size_t count, Outbox& outbox) {
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
    counts_.samples += taken;
    if (ready) {
      send_report(report, outbox);
      outlet::renew(config_, state_);
    }
  }
}

void Application::receive(const wire::Downlink& downlink, Outbox& outbox) {
  if (!started_) {
    return;
  }
  switch (downlink.kind) {
    case wire::DownlinkKind::kSettings:
      return take_settings(downlink, outbox);
    case wire::DownlinkKind::kCommand:
      return take_command(downlink, outbox);
    case wire::DownlinkKind::kIdentify:
      return send_hello(outbox, downlink.session);
    case wire::DownlinkKind::kAskStatus:
      return send_status(outbox);
    case wire::DownlinkKind::kAskSelfTest:
      return run_self_test(outbox);
    case wire::DownlinkKind::kPing:
      return put(outbox, UplinkKind::kEcho, &wire::Uplink::echo, {downlink.token});
  }
}

void Application::note(wire::ErrorCode error, Outbox& outbox) {
  const auto place = static_cast<std::size_t>(error);
  if (!started_ || place > static_cast<std::size_t>(wire::kLastErrorCode)) {
    return;
  }
  if (error == wire::ErrorCode::kBadFrame || error == wire::ErrorCode::kMalformed ||
      error == wire::ErrorCode::kUnknownKind) {
    ++counts_.messages_bad;
  }
  put(outbox, UplinkKind::kError, &wire::Uplink::error, {error, ++counts_.errors[place]});
}

void Application::refuse(wire::ErrorCode error, std::uint32_t detail, Outbox& outbox) {
  note_dropped();
  if (started_) {
    put(outbox, UplinkKind::kError, &wire::Uplink::error, {error, detail});
  }
}

void Application::note_samples_lost(std::uint32_t count, Outbox& outbox) {
  counts_.samples_lost += count;
  counts_.samples += count;
  outlet::lose_track(state_);
  note(wire::ErrorCode::kSamplesLost, outbox);
}

void Application::send_hello(Outbox& outbox, std::uint32_t session) const {
  wire::Hello hello = static_cast<const wire::Hello&>(identity_);
  hello.session = session;
  hello.firmware_version = kFirmwareVersion;
  hello.sample_rate_hz = config_.hardware.sample_rate_hz;
  hello.nominal_hz = config_.hardware.nominal_hz;
  hello.tracker_delay_s = outlet::kFrontEndDelay_s;
  hello.voltage_delay_s = outlet::kVoltageDelay_s;
  if (config_.has_settings) {
    hello.settings_version = outlet::accepted(config_).version;
    hello.settings_digest = outlet::digest(outlet::accepted(config_));
  }
  put(outbox, UplinkKind::kHello, &wire::Uplink::hello, hello);
}

void Application::take_settings(const wire::Downlink& sent, Outbox& outbox) {
  const outlet::Settings& settings = sent.settings;
  const outlet::SettingsError error = sent.settings_error != outlet::SettingsError::kNone
                                          ? sent.settings_error
                                          : outlet::apply(config_, state_, settings);
  // Settings that cannot be stored are applied all the same; the answer then has kept = false.
  // Refused settings leave those in force as they were, stored or not.
  const bool accepted = error == outlet::SettingsError::kNone;
  if (accepted) {
    kept_ = storage_ != nullptr && storage_->keep(settings);
  }
  // Version and digest are 0 without settings, as in the hello.
  put(outbox, UplinkKind::kSettingsAnswer, &wire::Uplink::settings_answer,
      {error, config_.has_settings ? outlet::accepted(config_).version : 0,
       config_.has_settings ? outlet::digest(outlet::accepted(config_)) : 0, kept_});
  if (accepted && storage_ != nullptr && !kept_) {
    note(wire::ErrorCode::kSettingsStorage, outbox);
  }
}

void Application::take_command(const wire::Downlink& command, Outbox& outbox) {
  const bool changed = outlet::command(state_, command.close_relay);
  answer_command(command, outbox);
  if (changed) {
    send_relay(outbox);
  }
}

void Application::answer_command(const wire::Downlink& command, Outbox& outbox) const {
  put(outbox, UplinkKind::kCommandAnswer, &wire::Uplink::command_answer,
      {command.request, state_.relay.closed, command.session});
}

void Application::run_self_test(Outbox& outbox) const {
  wire::SelfTest result;
  result.fingerprint = arithmetic_fingerprint();
  const auto errors = [&](wire::ErrorCode code) {
    return counts_.errors[static_cast<std::size_t>(code)];
  };
  if (result.fingerprint != kFingerprint) {
    result.failed |= wire::kArithmetic;
  }
  if (storage_ != nullptr && !storage_->usable()) {
    result.failed |= wire::kSettingsStorage;
  }
  if (errors(wire::ErrorCode::kClock) > 0) {
    result.failed |= wire::kClock;
  }
  if (state_.reports == 0) {
    result.failed |= wire::kAdc;
  }
  put(outbox, UplinkKind::kSelfTest, &wire::Uplink::self_test, result);
}

void Application::send_status(Outbox& outbox) const {
  put(outbox, UplinkKind::kStatus, &wire::Uplink::status,
      {state_.reports, state_.relay.closed, state_.relay.cause, state_.phase, counts_.samples_lost,
       counts_.messages_bad, counts_.messages_unsent, counts_.messages_dropped});
}

void Application::send_report(const outlet::Report& report, Outbox& outbox) const {
  put(outbox, UplinkKind::kMeasurement, &wire::Uplink::measurement,
      {report.measurement.frequency_hz, report.measurement.rocof_hz_s,
       report.measurement.voltage_pu, report.measurement.validity});
  if ((report.happened & outlet::kEvent) != 0) {
    put(outbox, UplinkKind::kEvent, &wire::Uplink::event,
        {report.baseline.frequency_hz, report.baseline.rocof_hz_s});
  }
  if ((report.happened & outlet::kLse) != 0) {
    put(outbox, UplinkKind::kLse, &wire::Uplink::lse, {report.lse_loss_mw});
  }
  if ((report.happened & outlet::kEstimate) != 0) {
    put(outbox, UplinkKind::kEstimate, &wire::Uplink::estimate,
        {report.loss_mw, report.loss_sigma_mw, report.loss_instant_s, report.trust});
  }
  if ((report.happened & outlet::kDecision) != 0) {
    put(outbox, UplinkKind::kDecision, &wire::Uplink::decision,
        {report.loss_mw, report.loss_sigma_mw, report.nadir_hz, report.required_mw,
         report.shed_before_mw, report.hits, report.trust, report.shed});
  }
  if ((report.happened & outlet::kRelay) != 0) {
    send_relay(outbox);
  }
  if ((report.happened & outlet::kAborted) != 0) {
    outbox.put(message(UplinkKind::kAborted));
  }
}

wire::Uplink Application::message(UplinkKind kind) const {
  wire::Uplink message;
  message.kind = kind;
  message.sample = counts_.samples;
  message.start_number = identity_.start_number;
  return message;
}

template <class Content>
void Application::put(Outbox& outbox, UplinkKind kind, Content wire::Uplink::*part,
                      const Content& content) const {
  wire::Uplink uplink = message(kind);
  uplink.*part = content;
  outbox.put(uplink);
}

void Application::send_relay(Outbox& outbox) const {
  put(outbox, UplinkKind::kRelay, &wire::Uplink::relay, {state_.relay.closed, state_.relay.cause});
}

}  // namespace gs::app
