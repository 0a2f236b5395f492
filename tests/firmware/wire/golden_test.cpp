// The encoding of a few messages, byte by byte, so that a change of the protocol is detected. The
// examples in exchange.md are the same messages.
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include <outlet/settings.hpp>

namespace gs::wire::test {
namespace {

constexpr std::uint32_t kStart = 0xC0FFEE07U;
constexpr std::uint32_t kSession = 0x5E551011U;

struct Golden {
  std::string name;
  Bytes is;         // encoded now
  std::string was;  // the fixed encoding, in hexadecimal
};

template <class Content>
Bytes up(UplinkKind kind, std::uint32_t sequence, std::uint64_t sample, Content Uplink::*member,
         const Content& content) {
  Uplink message;
  message.kind = kind;
  message.sample = sample;
  message.start_number = kStart;
  message.*member = content;
  return encoded(message, sequence);
}

Bytes down(Downlink message, std::uint32_t sequence) {
  message.session = kSession;
  message.start_number = kStart;
  return encoded(message, sequence);
}

Hello golden_hello() {
  Hello hello;
  std::strcpy(hello.id, "outlet-7");
  std::strcpy(hello.board, "mps2-an386");
  hello.instance = 0x12345678U;
  hello.firmware_version = 1000;
  hello.build = 0xDEADBEEFU;
  hello.capabilities = kKeepsSettings | kHasWatchdog;
  hello.sample_rate_hz = 8000;
  hello.nominal_hz = 50;
  hello.tracker_delay_s = 0.0625F;
  hello.voltage_delay_s = 0.03125F;
  return hello;
}

// Sets every field, so that the encoding does not depend on defaults.
outlet::Settings golden_settings() {
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
  settings.method = outlet::kByGridState;
  settings.threshold_hz = 49.5F;
  settings.nadir_margin_hz = 0.00390625F;
  settings.decision_reports = 40;
  settings.delay_s = 0.125F;
  settings.restore_hz = 49.75F;
  settings.restore_dwell_s = 64.0F;
  settings.restore_spread_s = 256.0F;
  return settings;
}

std::vector<Golden> goldens() {
  const Bytes identify = down(downlink(DownlinkKind::kIdentify), 0);
  const Bytes error = up(UplinkKind::kError, 66, 8100, &Uplink::error, {ErrorCode::kBadFrame, 1});
  return {
      {"hello", up(UplinkKind::kHello, 0, 0, &Uplink::hello, golden_hello()),
       "93 01 00 00 03 68 6f 75 74 6c 65 74 2d 37 1a c0 ff ee 07 6a 6d 70 73 32 "
       "2d 61 6e 33 38 36 1a 12 34 56 78 19 03 e8 1a de ad be ef 03 19 1f 40 18 "
       "32 fa 3d 80 00 00 fa 3d 00 00 00 00 00 00 00"},
      {"identify", identify, "83 03 00 1a 5e 55 10 11"},
      {"identify as a frame", framed(identify), "00 03 83 03 0a 1a 5e 55 10 11 87 6e f9 c2 00"},
      {"settings", down(settings_message(golden_settings()), 1),
       "84 01 01 1a 5e 55 10 11 b8 24 01 01 02 fa 3a 80 00 00 03 fa 3e 80 00 00 "
       "04 fa 3d 80 00 00 05 fa 3f a0 00 00 06 fa 43 b0 00 00 07 fa 45 2b 90 00 "
       "08 fa 42 c8 00 00 09 fa 42 44 00 00 0a 84 fa 42 47 00 00 fa bf 00 00 00 "
       "fa 42 46 00 00 fa be 80 00 00 0b 14 0c 08 0d 05 0e fa 3c 80 00 00 0f fa "
       "3d 00 00 00 10 0a 11 18 28 12 fa 3b 80 00 00 13 fa 42 b0 00 00 14 fa 3c "
       "00 00 00 15 fa 3c c0 00 00 16 fa 3c 40 00 00 17 03 18 18 fa 3a 80 00 00 "
       "18 19 fa 3f 40 00 00 18 1a fa 3d 50 00 00 18 1b fa 3d 80 00 00 18 1c fa "
       "3e 00 00 00 18 1d 01 18 1e fa 42 46 00 00 18 1f fa 3b 80 00 00 18 20 18 "
       "28 18 21 fa 3e 00 00 00 18 22 fa 42 47 00 00 18 23 fa 42 80 00 00 18 24 "
       "fa 43 80 00 00"},
      {"settings answer",
       up(UplinkKind::kSettingsAnswer, 1, 200, &Uplink::settings_answer,
          {outlet::SettingsError::kNone, 1, outlet::digest(golden_settings()), true}),
       "88 02 01 18 c8 1a c0 ff ee 07 00 01 1a 79 23 88 da f5"},
      {"first measurement, not settled",
       up(UplinkKind::kMeasurement, 0, 128, &Uplink::measurement,
          {NAN, NAN, 0.0F, outlet::Validity::kInvalid}),
       "88 03 00 18 80 1a c0 ff ee 07 fa 7f c0 00 00 fa 7f c0 00 00 fa 00 00 00 "
       "00 00"},
      {"measurement",
       up(UplinkKind::kMeasurement, 63, 8064, &Uplink::measurement,
          {49.984375F, -0.125F, 1.0F, outlet::Validity::kValid}),
       "88 03 18 3f 19 1f 80 1a c0 ff ee 07 fa 42 47 f0 00 fa be 00 00 00 fa 3f "
       "80 00 00 01"},
      {"command", down(command(false, 9), 2), "86 02 02 1a 5e 55 10 11 09 f4 1a c0 ff ee 07"},
      {"command answer",
       up(UplinkKind::kCommandAnswer, 64, 8064, &Uplink::command_answer, {9, false, kSession}),
       "87 0a 18 40 19 1f 80 1a c0 ff ee 07 09 f4 1a 5e 55 10 11"},
      {"relay", up(UplinkKind::kRelay, 65, 8064, &Uplink::relay, {false, outlet::Cause::kCommand}),
       "86 08 18 41 19 1f 80 1a c0 ff ee 07 f4 03"},
      {"error", error, "86 0e 18 42 19 1f a4 1a c0 ff ee 07 01 01"},
      {"error as a frame", framed(error),
       "00 13 86 0e 18 42 19 1f a4 1a c0 ff ee 07 01 01 1a 1f c8 17 00"},
  };
}

TEST(Golden, MessagesHaveTheirFixedEncoding) {
  for (const Golden& golden : goldens()) {
    EXPECT_EQ(hex(golden.is), golden.was) << golden.name;
  }
}

// The examples in the text's ```hex blocks, separated by empty lines.
std::set<std::string> examples_of_text() {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/wire/exchange.md");
  EXPECT_TRUE(file.is_open());
  std::set<std::string> examples;
  std::string line;
  std::string example;
  bool within = false;
  while (std::getline(file, line)) {
    const bool fence = line.rfind("```", 0) == 0;
    if (!within) {
      within = line == "```hex";
      continue;
    }
    if (fence || line.empty()) {
      if (!example.empty()) {
        examples.insert(example);
      }
      example.clear();
      within = !fence;
      continue;
    }
    std::istringstream words(line.substr(0, line.find('#')));
    for (std::string word; words >> word;) {
      example += (example.empty() ? "" : " ") + word;
    }
  }
  return examples;
}

TEST(Golden, ExamplesInTheTextAreTheEncodedMessages) {
  std::set<std::string> golden;
  for (const Golden& one : goldens()) {
    golden.insert(one.was);
  }
  EXPECT_EQ(examples_of_text(), golden);
}

// Compares the rows of the README's table of settings, "| 16 | lse_samples | u8 |", with the code.
TEST(Golden, SettingsInTheReadmeAreThoseOfTheCode) {
  std::ifstream file(GSBENCH_SOURCE_DIR "/firmware/wire/README.md");
  std::string line;
  while (std::getline(file, line) && line.rfind("| key | name", 0) != 0) {
  }
  std::getline(file, line);  // skips the line below the table's head
  const std::map<outlet::FieldType, std::string> types = {
      {outlet::FieldType::kU8, "u8"},
      {outlet::FieldType::kU16, "u16"},
      {outlet::FieldType::kU32, "u32"},
      {outlet::FieldType::kFloat, "f32"},
      {outlet::FieldType::kRows, "array of 2r"}};
  for (const outlet::Field& field : outlet::kSettingsFields) {
    std::getline(file, line);
    const std::string row =
        "| " + std::to_string(field.key) + " | " + field.name + " | " + types.at(field.type);
    EXPECT_EQ(line.substr(0, row.size()), row);
  }
  std::getline(file, line);
  EXPECT_EQ(line, "");
}

}  // namespace
}  // namespace gs::wire::test
