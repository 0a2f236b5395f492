// A model of waveform generator as data: its ranges, its memory, its dialect of SCPI and its
// quirks. A new model is a file instruments/NAME.toml (bench/station/instrument_file.hpp reads it;
// drivers/README.md documents its keys).
//
// Commands and expected values are templates. Placeholders: {channel}, {name} of the waveform,
// {points}, {bytes}, {rate_hz}, {frequency_hz} of the whole memory, {amplitude_vpp} and {offset_v}
// at the open output, {part} of a packet.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::scpi {

enum class RateAs : std::uint8_t {
  kSampleRate,  // points a second
  kFrequency    // repetitions a second of the whole memory
};

// What the output does between two points.
enum class Interpolation : std::uint8_t { kHold, kLinear };

enum class Codes : std::uint8_t {
  kSigned,   // 16 bits, −32 767 … 32 767 whatever the DAC's resolution; low bits are 0
  kUnsigned  // 0 … 2^bits − 1; the middle is between two codes
};

enum class ByteOrder : std::uint8_t { kLittle, kBig };

enum class Block : std::uint8_t {
  kRaw,      // the bytes follow the header; the message ends with a newline
  kBlock,    // IEEE 488.2 definite length block, #<digits><bytes>
  kPackets,  // several such blocks; {part} is more_part, in the last one last_part
};

enum class Verification : std::uint8_t {
  kReadBack,    // the waveform is read back and compared byte for byte
  kErrorQueue,  // the error queue must be empty after the upload
  kNone
};

enum class Quirk : std::uint8_t {
  kAvoidNewline,      // a byte 0x0A in the waveform ends the message: codes are moved off it
  kFixedLength,       // a waveform always fills the memory
  kUploadSwitchesOn,  // an upload may switch the output on: switched off and asked again after it
  kSilentIfUnknown    // unknown queries are not answered; the next one is
};

enum class When : std::uint8_t { kBeforeUpload, kAfterUpload };

enum class Compare : std::uint8_t { kText, kNumber };

// Where a value stands in an answer. Case, and quotes around a text, are ignored.
struct Field {
  std::string query;
  // Empty: the whole answer. Otherwise the answer is a comma list, with or without a header such as
  // "C1:BSWV ". A number is that of the item, from 1 on; a name is the item before the value.
  std::string field;
};

// A setting of the instrument: how it is set, and how it is asked back.
struct Setting {
  std::string name;  // for messages: "amplitude"
  When when = When::kAfterUpload;
  std::vector<std::string> commands;  // sent in this order; none: only asked
  Field asked;
  std::string expected;  // template; for kText: alternatives, separated by |
  Compare compare = Compare::kText;
  double tolerance = 0.0;       // of a number, absolute, in the unit of the answer
  double tolerance_ppm = 0.0;   // of a number, relative; the larger of both counts
  std::string unit;             // that may follow a number: "HZ"; case is ignored
  bool may_be_missing = false;  // older firmware does not list it
  bool watched = true;          // asked while the waveform plays, too
};

struct Amplitude {
  double lowest_vpp = 0.0;  // at the open output
  double highest_vpp = 0.0;
  double resolution_vpp = 0.0;
};

struct Rate {
  RateAs set_as = RateAs::kSampleRate;
  double lowest_hz = 0.0;  // points a second
  double highest_hz = 0.0;
  double resolution_hz = 0.0;  // of what is set: sample rate or frequency
  Interpolation interpolation = Interpolation::kHold;
};

struct Memory {
  std::int64_t points = 0;         // of the longest waveform
  std::int64_t fewest_points = 2;  // of the shortest waveform
  std::int64_t packet_points = 0;  // of the largest packet; 0: no packets
};

struct Format {
  int bits = 16;  // resolution of the DAC
  Codes codes = Codes::kSigned;
  ByteOrder byte_order = ByteOrder::kLittle;
  Block block = Block::kBlock;
};

// From the maker's table; not calibrated.
struct Accuracy {
  double clock_ppm = 0.0;              // ±
  double amplitude_pct = 0.0;          // ±
  double trigger_latency_s = 0.0;      // from sending the trigger to the first point
  double trigger_uncertainty_s = 0.0;  // ±
};

struct Timing {
  double command_s = 0.0;  // pause after each command
  double packet_s = 0.0;   // after each packet
  double reset_s = 0.0;    // after a reset
  double upload_s = 0.0;   // after an upload
  double answer_s = 2.0;   // longest wait for an answer
  // The slowest rate at which it takes a waveform, bytes/s.
  double upload_bytes_s = 1e5;
};

struct Dialect {
  std::vector<std::string> reset;  // after the output is off
  std::string clear;      // frees or overwrites the memory before an upload; empty: not needed
  std::string upload;     // header of an upload or packet, up to the block
  std::string more_part;  // {part} of a packet before the last one
  std::string last_part;  // {part} of the last packet
  std::string read_back;  // query of the waveform; its answer has LENGTH,<n>B … WAVEDATA,<bytes>
  std::string trigger;    // plays the waveform once
  std::string output_on;
  std::string output_off;
  Field output;       // asks for the state
  std::string is_on;  // alternatives, separated by |
  std::string is_off;
  std::string next_error;  // query of the error queue; empty: there is none
};

struct Instrument {
  std::string name;                   // of the file: "siglent-sdg2000x"
  std::string title;                  // maker and model
  std::vector<std::string> identity;  // how an answer to *IDN? may begin; ? is any character
  Amplitude amplitude;
  Rate rate;
  Memory memory;
  Format format;
  Accuracy accuracy;
  Timing timing;
  Verification verification = Verification::kNone;
  std::vector<Quirk> quirks;
  Dialect dialect;
  std::vector<Setting> settings;  // in the order in which they are sent

  bool has(Quirk quirk) const;
  // Whether this answer to *IDN? is of this model.
  bool is(const std::string& identification) const;
  double middle_code() const;      // of 0 V
  double full_scale_code() const;  // from the middle to the highest level: half the amplitude
  int code_step() const;           // from one level of the DAC to the next
};

// Of a command, a query or an expected answer. An error if it contains a control character, such as
// a line end, or a placeholder that is unknown or not closed.
[[nodiscard]] drivers::Status check_text(const std::string& text);
// Of Field::field. An error if it is a number that no item has.
[[nodiscard]] drivers::Status check_field(const std::string& field);

// An error names the first contradiction between the members: ranges, missing commands, and what
// check_text() and check_field() refuse.
[[nodiscard]] drivers::Status check(const Instrument& instrument);

}  // namespace gsbench::scpi
