// Messages between the bench and a DAC head. protocol.md specifies the protocol; fields.hpp lists
// each message's fields in their order on the wire. Plain data without pointers.
//
// Stream: the samples of a run, from 0, kSampleRate_hz of them a second. The head plays them on its
// own clock and measures the edges of its inputs on the same clock.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gs::head {

constexpr std::uint16_t kProtocolVersion = 1;

constexpr std::uint32_t kSampleRate_hz = 8000;  // of the stream
constexpr std::uint32_t kOversampling = 8;      // codes of the DAC for each sample
constexpr std::uint32_t kCodeRate_hz = kSampleRate_hz * kOversampling;
// The largest sample, 1792 steps of the DAC: its output buffer reaches from 0.2 V to 0.2 V below
// the supply of 3.3 V (datasheet of the STM32F405, DAC characteristics); this is 1.65 V ± 1.444 V.
constexpr std::int16_t kFullScale = 1792 * 16;
constexpr std::uint16_t kFullScale_mv = 1444;
constexpr std::size_t kBufferSamples = 4096;  // of the head
constexpr std::size_t kLongestSamples = 256;  // in one message
constexpr std::size_t kInputs = 4;
constexpr std::uint16_t kWatchdog_ms = 200;
constexpr std::uint32_t kStatusPeriod_ms = 8;
constexpr std::size_t kKeptEdges = 64;  // the newest ones can be asked for again

constexpr std::size_t kBoardBytes = 16;
constexpr std::size_t kUniqueIdBytes = 12;

enum class Kind : std::uint8_t {
  // from the bench
  kIdentify = 0x01,
  kArm = 0x02,
  kSamples = 0x03,
  kPlay = 0x04,
  kStop = 0x05,
  kPing = 0x06,
  kResendEdges = 0x07,
  // from the head
  kHello = 0x11,
  kStatus = 0x12,
  kEdge = 0x13,
  kRefused = 0x14,
};

enum class State : std::uint8_t {
  kOff = 0,      // mid-scale; samples are refused
  kArmed = 1,    // mid-scale; samples are taken
  kPlaying = 2,  // the stream is at the output
  kFaulted = 3,  // mid-scale, until stop or identify; Status::fault is the reason
};
constexpr State kLastState = State::kFaulted;

enum class Fault : std::uint8_t {
  kNone = 0,
  kWatchdog = 1,  // no message was accepted for kWatchdog_ms
  kUnderrun = 2,  // the next sample was not there in time
  kHardware = 3,  // the DAC did not get its codes in time
};
constexpr Fault kLastFault = Fault::kHardware;

// Why a message was not accepted. It has no effect, and its number is still expected.
enum class Refusal : std::uint8_t {
  kMalformed = 1,      // too short or too long for its kind, or too many samples
  kUnknownKind = 2,    // not one of those from the bench
  kNotIdentified = 3,  // nothing but identify, stop and ping is accepted before an identify
  kVersion = 4,        // the same, if the identify was of another protocol version
  kGap = 5,            // messages before this one are missing
  kState = 6,          // not in this state
  kPosition = 7,       // the first sample is not the next one of the stream
  kNoRoom = 8,         // more samples than there is room for
  kRange = 9,          // a sample is beyond full scale, or a prefill beyond the buffer
  kNotKept = 10,       // edges that have not happened yet, or are no longer kept
};
constexpr Refusal kFirstRefusal = Refusal::kMalformed;
constexpr Refusal kLastRefusal = Refusal::kNotKept;

// Bits of Hello::flags.
enum HelloFlag : std::uint16_t {
  kCrystalRuns = 1,         // 0: a clock accurate to 1 % only; a bench must not play
  kRestartedByWatchdog = 2  // of the processor: the firmware had hung
};

// ---- from the bench

// Begins a session: output off, everything cleared. Accepted with any number.
struct Identify {
  static constexpr Kind kKind = Kind::kIdentify;
  std::uint16_t protocol_version = kProtocolVersion;
};

// From kOff to kArmed. Clears the buffer and the edges; the next sample is sample 0.
struct Arm {
  static constexpr Kind kKind = Kind::kArm;
  std::uint32_t run = 0;  // any number; the status repeats it
};

struct Samples {
  static constexpr Kind kKind = Kind::kSamples;
  std::uint64_t first_sample = 0;
  std::uint16_t count = 0;  // 1 … kLongestSamples
  // Deviation from mid-scale in 1/16 of a step of the DAC, −kFullScale … kFullScale.
  std::int16_t samples[kLongestSamples] = {};
};

// From kArmed to kPlaying as soon as the buffer contains `prefill` samples.
struct Play {
  static constexpr Kind kKind = Kind::kPlay;
  std::uint16_t prefill = 0;  // 1 … kBufferSamples
};

// Output off, from any state. Accepted with any number.
struct Stop {
  static constexpr Kind kKind = Kind::kStop;
};

// Keeps the watchdog quiet and asks for a status. Uses no number; its number is that of the next
// message.
struct Ping {
  static constexpr Kind kKind = Kind::kPing;
  std::uint32_t token = 0;  // returned as Status::echo
};

// Asks for the edges from this one on again.
struct ResendEdges {
  static constexpr Kind kKind = Kind::kResendEdges;
  std::uint32_t first_edge = 0;
};

// ---- from the head

// At start-up, and in answer to identify.
struct Hello {
  static constexpr Kind kKind = Kind::kHello;
  std::uint16_t protocol_version = kProtocolVersion;
  std::uint16_t flags = 0;
  char board[kBoardBytes + 1] = {};
  std::uint8_t unique_id[kUniqueIdBytes] = {};
  std::uint32_t firmware_version = 0;  // major · 10⁶ + minor · 10³ + patch
  std::uint32_t build = 0;             // first 32 bits of the SHA-256 over the firmware's sources
  std::uint32_t sample_rate_hz = kSampleRate_hz;
  std::uint8_t oversampling = kOversampling;
  std::uint8_t dac_bits = 12;
  std::int16_t full_scale = kFullScale;
  std::uint16_t full_scale_mv = kFullScale_mv;  // nominal, peak
  std::uint16_t buffer_samples = kBufferSamples;
  std::uint16_t longest_samples = kLongestSamples;
  std::uint32_t counts_per_sample = 0;  // counts of the capture timer
  std::uint8_t inputs = kInputs;
  std::uint16_t watchdog_ms = kWatchdog_ms;
};

struct Status {
  static constexpr Kind kKind = Kind::kStatus;
  State state = State::kOff;
  Fault fault = Fault::kNone;   // of kFaulted
  std::uint32_t run = 0;        // of the newest arm
  std::uint32_t expected = 0;   // number of the next message from the bench
  std::uint64_t position = 0;   // samples of this run that were given to the DAC
  std::uint16_t room = 0;       // samples for which the buffer has room now
  std::int64_t count = 0;       // timer counts from sample 0 at the output until now; 0 before play
  std::uint32_t echo = 0;       // token of the newest ping
  std::uint32_t edges = 0;      // since arm
  std::uint8_t closed = 0;      // bit i: input i is closed now
  std::uint32_t underruns = 0;  // this and the following: since start-up
  std::uint32_t watchdog_trips = 0;
  std::uint32_t bad_frames = 0;
  std::uint32_t edges_missed = 0;  // closer together than the head can measure
};

struct Edge {
  static constexpr Kind kKind = Kind::kEdge;
  std::uint32_t edge = 0;  // 0, 1, … since arm
  std::uint8_t input = 0;  // 0 … kInputs − 1
  bool closed = false;
  // Timer counts from sample 0 at the output to the edge; may be negative, by up to 2.1 ms.
  std::int64_t count = 0;
};

struct Refused {
  static constexpr Kind kKind = Kind::kRefused;
  Refusal reason = Refusal::kMalformed;
  std::uint32_t refused = 0;   // number of the refused message; 0 if it is too short to have one
  std::uint32_t expected = 0;  // number of the next message from the bench
};

}  // namespace gs::head
