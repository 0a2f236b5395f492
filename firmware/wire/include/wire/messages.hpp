// What an outlet and a control centre (or the bench in its place) say to each other, over any link.
//
// Time in a message is the outlet's own sample count: the number of samples it had taken when the
// thing happened. Plain data without pointers; how it is put on a serial line or a broker is the
// link's business.
#pragma once

#include <cstdint>

#include <outlet/outlet.hpp>

namespace gs::wire {

constexpr std::uint16_t kProtocolVersion = 1;

// ---- from the outlet

enum class UplinkKind : std::uint8_t {
  kHello = 1,
  kSettingsAnswer = 2,
  kMeasurement = 3,
  kEvent = 4,
  kLse = 5,
  kEstimate = 6,
  kDecision = 7,
  kRelay = 8,
  kAborted = 9,
};

struct Hello {
  std::uint16_t protocol_version = kProtocolVersion;
  std::uint32_t firmware_version = 0;  // major·10⁶ + minor·10³ + patch
  std::int32_t sample_rate_hz = 0;
  std::int32_t nominal_hz = 0;
  float tracker_delay_s = 0.0f;  // a measurement is of the frequency so long before its stamp
};

struct SettingsAnswer {
  outlet::SettingsError error = outlet::SettingsError::kNone;
  std::uint32_t version = 0;  // in force now
  std::uint32_t digest = 0;   // of what is in force now
};

struct MeasurementMessage {
  float frequency_hz = 0.0f;  // NaN where invalid
  float rocof_hz_s = 0.0f;    // NaN where invalid
  float voltage_pu = 0.0f;
  outlet::Validity validity = outlet::Validity::kInvalid;
};

struct EventMessage {
  float baseline_hz = 0.0f;
  float baseline_rocof_hz_s = 0.0f;
};

struct LseMessage {
  float loss_mw = 0.0f;
};

struct EstimateMessage {
  float loss_mw = 0.0f;
  float loss_sigma_mw = 0.0f;
  float loss_instant_s = 0.0f;  // against the event's stamp, the tracker's delay taken off
  outlet::Trust trust = outlet::Trust::kNotYet;
};

struct DecisionMessage {
  float loss_mw = 0.0f;
  float required_mw = 0.0f;  // ΔP_v
  std::uint16_t hits = 0;
  outlet::Trust trust = outlet::Trust::kNotYet;
  bool shed = false;
};

struct RelayMessage {
  bool closed = true;
  outlet::Cause cause = outlet::Cause::kNone;
};

struct Uplink {
  UplinkKind kind = UplinkKind::kHello;
  std::uint64_t sample = 0;
  union {
    Hello hello;
    SettingsAnswer settings_answer;
    MeasurementMessage measurement;
    EventMessage event;
    LseMessage lse;
    EstimateMessage estimate;
    DecisionMessage decision;
    RelayMessage relay;
  };

  Uplink() : hello{} {}
};

// ---- to the outlet

enum class DownlinkKind : std::uint8_t { kSettings = 1, kCommand = 2 };

struct Downlink {
  DownlinkKind kind = DownlinkKind::kCommand;
  outlet::Settings settings;  // of kSettings
  bool close_relay = true;    // of kCommand
};

}  // namespace gs::wire
