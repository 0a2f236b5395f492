#include "golden.hpp"

#include <cmath>
#include <cstring>

namespace gs::wire::test {
namespace {

Uplink up(UplinkKind kind, std::uint64_t sample) {
  Uplink message;
  message.kind = kind;
  message.sample = sample;
  return message;
}

Downlink down(DownlinkKind kind) {
  Downlink message;
  message.kind = kind;
  return message;
}

Uplink hello() {
  Uplink message = up(UplinkKind::kHello, 0);
  std::strcpy(message.hello.id, "outlet-7");
  std::strcpy(message.hello.board, "mps2-an386");
  message.hello.instance = 0x12345678U;
  message.hello.firmware_version = 1000;
  message.hello.build = 0xDEADBEEFU;
  message.hello.capabilities = kKeepsSettings | kHasWatchdog;
  message.hello.sample_rate_hz = 8000;
  message.hello.nominal_hz = 50;
  message.hello.tracker_delay_s = 0.0625F;
  message.hello.voltage_delay_s = 0.03125F;
  return message;
}

// Every field, so that other defaults would not show here.
outlet::Settings settings() {
  outlet::Settings settings;
  settings.version = 1;
  settings.response.gain_hz_per_mw = 0.0009765625F;
  settings.response.sigma_per_s = 0.25F;
  settings.response.discriminant_per_s2 = 0.0625F;
  settings.response.initial_slope_per_s = 1.25F;
  settings.threshold_mw = 352.0F;
  settings.largest_loss_mw = 2745.0F;
  settings.accumulated_mw = 100.0F;
  settings.switch_off_hz = 49.0F;
  settings.condition_rows = 2;
  settings.conditions[0] = {49.75F, -0.5F};
  settings.conditions[1] = {49.5F, -0.25F};
  settings.condition_hits = 20;
  settings.rocof_samples = 8;
  settings.event_drops = 5;
  settings.event_drop_hz = 0.015625F;
  settings.event_departure_hz = 0.03125F;
  settings.lse_samples = 10;
  settings.ekf_samples = 40;
  settings.measurement_sigma_hz = 0.00390625F;
  settings.loss_sigma_mw = 88.0F;
  settings.event_lag_s = 0.0078125F;
  settings.t_x_sigma_s = 0.0234375F;
  settings.trusted_residual_hz = 0.01171875F;
  settings.switch_off_samples = 3;
  settings.tracker.phase_noise_rad = 0.0009765625F;
  settings.tracker.jerk_rad_s3_per_sqrt_hz = 0.75F;
  settings.tracker.innovation_gate_rad = 0.05078125F;
  settings.tracker.innovation_gate_amplitude = 0.0625F;
  settings.tracker.dead_bus_pu = 0.125F;
  return settings;
}

Downlink settings_message() {
  Downlink message = down(DownlinkKind::kSettings);
  message.settings = settings();
  return message;
}

Uplink settings_answer() {
  Uplink message = up(UplinkKind::kSettingsAnswer, 200);
  message.settings_answer = {outlet::SettingsError::kNone, 1, outlet::digest(settings()), true};
  return message;
}

Uplink measurement() {
  Uplink message = up(UplinkKind::kMeasurement, 128);
  message.measurement = {NAN, NAN, 0.0F, outlet::Validity::kInvalid};
  return message;
}

Uplink valid_measurement() {
  Uplink message = up(UplinkKind::kMeasurement, 8064);
  message.measurement = {49.984375F, -0.125F, 1.0F, outlet::Validity::kValid};
  return message;
}

Downlink command() {
  Downlink message = down(DownlinkKind::kCommand);
  message.request = 9;
  message.close_relay = false;
  return message;
}

Uplink command_answer() {
  Uplink message = up(UplinkKind::kCommandAnswer, 8064);
  message.command_answer = {9, false};
  return message;
}

Uplink relay() {
  Uplink message = up(UplinkKind::kRelay, 8064);
  message.relay = {false, outlet::Cause::kCommand};
  return message;
}

Uplink error() {
  Uplink message = up(UplinkKind::kError, 8100);
  message.error = {ErrorCode::kBadFrame, 1};
  return message;
}

}  // namespace

std::vector<Golden> goldens() {
  return {
      {"hello", encoded(hello(), 0),
       "90 01 00 00 02 68 6f 75 74 6c 65 74 2d 37 6a 6d 70 73 32 2d 61 6e 33 38 "
       "36 1a 12 34 56 78 19 03 e8 1a de ad be ef 03 19 1f 40 18 32 fa 3d 80 00 "
       "00 fa 3d 00 00 00 00 00"},
      {"identify", encoded(down(DownlinkKind::kIdentify), 0), "82 03 00"},
      {"identify as a frame", framed(encoded(down(DownlinkKind::kIdentify), 0)),
       "00 03 82 03 05 3f 45 dd 36 00"},
      {"settings", encoded(settings_message(), 1),
       "83 01 01 b8 1c 01 01 02 fa 3a 80 00 00 03 fa 3e 80 00 00 04 fa 3d 80 00 "
       "00 05 fa 3f a0 00 00 06 fa 43 b0 00 00 07 fa 45 2b 90 00 08 fa 42 c8 00 "
       "00 09 fa 42 44 00 00 0a 84 fa 42 47 00 00 fa bf 00 00 00 fa 42 46 00 00 "
       "fa be 80 00 00 0b 14 0c 08 0d 05 0e fa 3c 80 00 00 0f fa 3d 00 00 00 10 "
       "0a 11 18 28 12 fa 3b 80 00 00 13 fa 42 b0 00 00 14 fa 3c 00 00 00 15 fa "
       "3c c0 00 00 16 fa 3c 40 00 00 17 03 18 18 fa 3a 80 00 00 18 19 fa 3f 40 "
       "00 00 18 1a fa 3d 50 00 00 18 1b fa 3d 80 00 00 18 1c fa 3e 00 00 00"},
      {"settings answer", encoded(settings_answer(), 3), "87 02 03 18 c8 00 01 1a a5 6a 7f e2 f5"},
      {"first measurement, not settled", encoded(measurement(), 1),
       "87 03 01 18 80 fa 7f c0 00 00 fa 7f c0 00 00 fa 00 00 00 00 00"},
      {"measurement", encoded(valid_measurement(), 65),
       "87 03 18 41 19 1f 80 fa 42 47 f0 00 fa be 00 00 00 fa 3f 80 00 00 01"},
      {"command", encoded(command(), 2), "84 02 02 09 f4"},
      {"command answer", encoded(command_answer(), 66), "85 0a 18 42 19 1f 80 09 f4"},
      {"relay", encoded(relay(), 67), "85 08 18 43 19 1f 80 f4 03"},
      {"error", encoded(error(), 68), "85 0e 18 44 19 1f a4 01 01"},
      {"error as a frame", framed(encoded(error(), 68)),
       "00 0e 85 0e 18 44 19 1f a4 01 01 1e 9f 5e ca 00"},
  };
}

}  // namespace gs::wire::test
