// Messages between an outlet and a control centre (or the bench in its place), over any link.
// README.md specifies the protocol; fields.hpp lists each message's fields in their order on the
// wire. Plain data without pointers.
//
// Time in a message is the outlet's sample count: the number of samples taken before the moment
// that the message describes. It says nothing about the order of messages: start and sequence
// numbers do.
#pragma once

#include <cstddef>
#include <cstdint>

#include <outlet/outlet.hpp>

namespace gs::wire {

constexpr std::uint16_t kProtocolVersion = 3;
constexpr std::size_t kLongestId = 32;
constexpr std::size_t kLongestBoard = 16;

// ---- from the outlet

enum class UplinkKind : std::uint8_t {
  kHello = 1,           // after start-up, and in answer to identify
  kSettingsAnswer = 2,  // answer to settings
  kMeasurement = 3,     // every 16 ms
  kEvent = 4,
  kLse = 5,
  kEstimate = 6,
  kDecision = 7,
  kRelay = 8,  // the relay was commanded to change
  kAborted = 9,
  kCommandAnswer = 10,
  kStatus = 11,
  kSelfTest = 12,
  kEcho = 13,
  kError = 14,
};
constexpr UplinkKind kLastUplink = UplinkKind::kError;

// Bits of Hello::capabilities.
enum Capability : std::uint32_t {
  kKeepsSettings = 1,  // through a loss of power
  kHasWatchdog = 2,
};

// Limits of a hello's fields.
constexpr std::int32_t kLeastSampleRate_hz = 1000;
constexpr std::int32_t kMostSampleRate_hz = 1000000;
constexpr float kLongestDelay_s = 1.0f;

// Every protocol version's hello begins with protocol_version and id. If the version is another
// one, the receiver reads only these two fields.
struct Hello {
  std::uint16_t protocol_version = kProtocolVersion;
  char id[kLongestId + 1] = {};        // set at manufacture: letters, digits, '-', '_', '.'
  char board[kLongestBoard + 1] = {};  // hardware type: "mps2-an386"
  std::uint32_t instance = 0;  // unique number of this unit: distinguishes two with the same id
  std::uint32_t firmware_version = 0;  // major·10⁶ + minor·10³ + patch
  std::uint32_t build = 0;             // first 32 bits of the SHA-256 over the firmware's sources
  std::uint32_t capabilities = 0;
  std::int32_t sample_rate_hz = 0;
  std::int32_t nominal_hz = 0;
  float tracker_delay_s = 0.0f;        // age of a measured frequency at its time stamp
  float voltage_delay_s = 0.0f;        // age of a measured voltage at its time stamp
  std::uint32_t settings_version = 0;  // accepted last; 0: none
  std::uint32_t settings_digest = 0;   // outlet::digest of them; 0: none
  std::uint32_t session = 0;           // of the identify that it answers; 0: sent unasked
  std::uint32_t next_number = 0;       // of the message that follows, hellos not counted
};

// Whether all fields are within their ranges. Of another version, only the id is checked.
bool is_valid(const Hello& hello);

struct SettingsAnswer {
  outlet::SettingsError error = outlet::SettingsError::kNone;
  // Of the settings accepted last, which come into force after an event that is under way.
  std::uint32_t version = 0;  // 0: none
  std::uint32_t digest = 0;   // 0: none
  bool kept = false;          // they are stored: they survive a loss of power
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
  float loss_instant_s = 0.0f;  // relative to the event's stamp, tracker delay subtracted
  outlet::Trust trust = outlet::Trust::kNotYet;
};

struct DecisionMessage {
  float loss_mw = 0.0f;
  float loss_sigma_mw = 0.0f;
  // Predicted if nothing more is shed; NaN with method 0, or if the event had no confirmed change.
  float nadir_hz = 0.0f;
  float required_mw = 0.0f;     // ΔP_v: what must be shed now
  float shed_before_mw = 0.0f;  // required by earlier decisions that were followed
  std::uint16_t hits = 0;
  outlet::Trust trust = outlet::Trust::kNotYet;
  bool shed = false;
};

struct RelayMessage {
  bool closed = true;
  outlet::Cause cause = outlet::Cause::kNone;
};

struct CommandAnswer {
  std::uint32_t request = 0;  // of the command
  bool closed = true;         // the relay's state now
  std::uint32_t session = 0;  // of the command
};

struct Status {
  std::uint32_t reports = 0;  // since start-up, 16 ms each
  bool relay_closed = true;
  outlet::Cause cause = outlet::Cause::kNone;
  outlet::Phase phase = outlet::Phase::kQuiet;
  std::uint32_t samples_lost = 0;     // delivered by the ADC but not taken, since start-up
  std::uint32_t messages_bad = 0;     // received as bad frame, malformed or of an unknown kind
  std::uint32_t messages_unsent = 0;  // dropped because the link or the broker did not take them
  // Received and dropped: late or duplicate, of an unknown session, commands for another start.
  std::uint32_t messages_dropped = 0;
};

// Bits of SelfTest::failed.
enum SelfTestPart : std::uint32_t {
  kArithmetic = 1,       // the fingerprint differs from the required one
  kSettingsStorage = 2,  // stored settings cannot be read
  kClock = 4,            // the crystal did not start; the board runs on another oscillator
  kAdc = 8,              // no samples arrive
};

struct SelfTest {
  std::uint32_t failed = 0;
  std::uint32_t fingerprint =
      0;  // of the result for a known signal; equal on all boards and builds
};

struct Echo {
  std::uint32_t token = 0;  // of the ping
};

enum class ErrorCode : std::uint8_t {
  kBadFrame = 1,         // not COBS, too long, or its CRC is wrong
  kMalformed = 2,        // not a message of this protocol
  kUnknownKind = 3,      // a message of an unknown kind
  kSamplesLost = 4,      // the firmware was too slow for its ADC
  kSettingsStorage = 5,  // settings could not be stored
  kWatchdog = 6,         // the watchdog restarted the outlet
  kClock = 7,            // the crystal did not start
  kUnknownSession = 8,   // a message of a session that no identify has begun
  kOtherStart = 9,       // a command for another start of the outlet
};
constexpr ErrorCode kFirstErrorCode = ErrorCode::kBadFrame;
constexpr ErrorCode kLastErrorCode = ErrorCode::kOtherStart;

struct ErrorMessage {
  ErrorCode code = ErrorCode::kMalformed;
  // kUnknownSession: the session. kOtherStart: the command's request. Otherwise the number of
  // errors of this code since start-up.
  std::uint32_t detail = 0;
};

struct Uplink {
  UplinkKind kind = UplinkKind::kHello;
  std::uint64_t sample = 0;
  std::uint32_t start_number = 0;  // another one for each start-up of the outlet
  union {
    Hello hello;
    SettingsAnswer settings_answer;
    MeasurementMessage measurement;
    EventMessage event;
    LseMessage lse;
    EstimateMessage estimate;
    DecisionMessage decision;
    RelayMessage relay;
    CommandAnswer command_answer;
    Status status;
    SelfTest self_test;
    Echo echo;
    ErrorMessage error;
  };

  Uplink() : hello{} {}
};

// ---- to the outlet

enum class DownlinkKind : std::uint8_t {
  kSettings = 1,
  kCommand = 2,
  kIdentify = 3,  // answered by a hello
  kAskStatus = 4,
  kAskSelfTest = 5,
  kPing = 6,  // answered by an echo, at once
};
constexpr DownlinkKind kLastDownlink = DownlinkKind::kPing;

constexpr std::uint32_t kNoSession = 0;

struct Downlink {
  DownlinkKind kind = DownlinkKind::kCommand;
  std::uint32_t session = kNoSession;  // another one for each start of the centre
  outlet::Settings settings;           // of kSettings
  // Of kSettings, set by decode(): kNone or kUnknownField.
  outlet::SettingsError settings_error = outlet::SettingsError::kNone;
  bool close_relay = true;         // of kCommand
  std::uint32_t request = 0;       // of kCommand: from 1, counted up; repeated in its answer
  std::uint32_t start_number = 0;  // of kCommand: the outlet's start for which it is meant
  std::uint32_t token = 0;         // of kPing
};

// A kIdentify message. The link sets its session.
Downlink identify();

const char* to_string(UplinkKind kind);
const char* to_string(ErrorCode code);

}  // namespace gs::wire
