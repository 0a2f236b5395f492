// Seeds of the wire fuzzers: real messages, frames, settings and settings storages.
#include "flash_cells.hpp"
#include "wire_input.hpp"
#include <firmware_test/settings.hpp>
#include <settings_storage/settings_storage.hpp>
#include <wire_test/messages.hpp>

namespace gsbench::fuzz {
namespace {

using gs::wire::test::Bytes;
using gs::wire::test::encoded;
using gs::wire::test::framed;

std::string text_of(const Bytes& bytes) {
  return {bytes.begin(), bytes.end()};
}

std::vector<Bytes> messages() {
  constexpr int kTimes = 3;
  std::vector<Bytes> all;
  std::uint32_t sequence = 0;
  for (const auto& message : gs::wire::test::many_uplinks(kTimes)) {
    all.push_back(encoded(message, sequence++));
  }
  for (const auto& message : gs::wire::test::many_downlinks(kTimes)) {
    all.push_back(encoded(message, sequence++));
  }
  gs::wire::Downlink valid;
  valid.kind = gs::wire::DownlinkKind::kSettings;
  valid.settings = gs::test::ieee24_settings();
  all.push_back(encoded(valid, sequence));
  return all;
}

std::vector<std::string> message_seeds() {
  std::vector<std::string> seeds;
  for (const Bytes& message : messages()) {
    seeds.push_back(text_of(message));
  }
  return seeds;
}

// Single frames and a short sequence of frames. Longer inputs would only be slower.
std::vector<std::string> stream_seeds() {
  std::vector<std::string> seeds;
  constexpr std::size_t kLongestSeed = 1500;
  std::string some;
  for (const Bytes& message : messages()) {
    seeds.push_back(text_of(framed(message)));
    if (some.size() < kLongestSeed) {
      some += seeds.back();
    }
  }
  seeds.push_back(some);
  return seeds;
}

std::vector<gs::outlet::Settings> some_settings() {
  std::vector<gs::outlet::Settings> all = {gs::test::ieee24_settings(), gs::outlet::Settings{}};
  gs::outlet::Settings one_row = all[0];
  one_row.condition_rows = 1;
  one_row.version = 0xFFFFFFFFU;
  all.push_back(one_row);
  gs::outlet::Settings without_version = all[0];
  without_version.version = gs::outlet::kNoSettings;
  all.push_back(without_version);
  return all;
}

std::vector<std::string> settings_seeds() {
  // Omitted, duplicate and unknown settings.
  std::vector<std::string> seeds = {"\xA1\x10\x0A", "\xA2\x10\x0A\x10\x0A", "\xA1\x18\xC8\xF6"};
  for (const auto& settings : some_settings()) {
    seeds.push_back(text_of(encoded(settings)));
  }
  return seeds;
}

// Erased, one slot written, both slots written.
std::vector<std::string> flash_seeds() {
  FlashCells cells;
  gs::settings_storage::FlashSettingsStorage storage(cells);
  std::vector<std::string> seeds = {text_of(cells.bytes())};
  for (const auto& settings : some_settings()) {
    if (storage.keep(settings)) {
      seeds.push_back(text_of(cells.bytes()));
    }
  }
  return seeds;
}

}  // namespace

const std::vector<WireFuzzer>& wire_fuzzers() {
  static const std::vector<WireFuzzer> fuzzers = {
      {"frame", wrong_with_stream, stream_seeds},
      {"cbor", wrong_with_message, message_seeds},
      {"settings", wrong_with_settings, settings_seeds},
      {"flash", wrong_with_flash, flash_seeds},
      {"head", wrong_with_head, head_seeds},
  };
  return fuzzers;
}

}  // namespace gsbench::fuzz
