#include "generator_keysight.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::string_view kBuiltIn = "INT:\\BUILTIN\\EXP_RISE.ARB";

}  // namespace

void Keysight::add_arbitrary() {
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary",
      [this](std::string_view argument) { select(argument); },
      [this](std::string_view) {
        const std::string& name = state_.settings().waveform;
        return "\"" + (name.empty() ? std::string(kBuiltIn) : name) + "\"";
      });
  add_number("[SOURce:]FUNCtion[:SHAPe]:ARBitrary:SRATe", &GeneratorSettings::sample_rate_hz, 1e-6,
             state_.facts().highest_rate_hz);
  // OFF steps from point to point. NORMal and STEP are low-pass filters of the maker's; at mains
  // frequency, joined points differ from them by less than 1e-4 from 10 kSa/s on.
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary:FILTer",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "STEP", "OFF"});
        if (!name.empty()) {
          filter_ = name;
          change([&](GeneratorSettings& next) {
            next.between = name == "OFF" ? Between::kHold : Between::kLine;
          });
        }
      },
      [this](std::string_view) { return short_form(filter_); });
  // Points that advance by triggers are not emulated.
  add(
      "[SOURce:]FUNCtion[:SHAPe]:ARBitrary:ADVance",
      [this](std::string_view argument) { one_of(argument, {"SRATe"}); },
      [](std::string_view) { return "SRAT"; });
  add("[SOURce:]FUNCtion[:SHAPe]:ARBitrary:POINts", {}, [this](std::string_view) {
    const GeneratorWaveform* const found = state_.find(state_.settings().waveform);
    return fmt::format("{:+d}", found == nullptr ? 100 : static_cast<int>(found->points()));
  });
}

void Keysight::add_data() {
  add("[SOURce:]DATA:ARBitrary", [this](std::string_view argument) { take_data(argument, false); },
      {});
  add("[SOURce:]DATA:ARBitrary:DAC",
      [this](std::string_view argument) { take_data(argument, true); }, {});
  add("[SOURce:]DATA:VOLatile:CLEar", [this](std::string_view) { state_.forget_waveforms(); }, {});
  add("[SOURce:]DATA:VOLatile:CATalog", {}, [this](std::string_view) {
    std::string list = "\"" + std::string(kBuiltIn) + "\"";
    for (const std::string& name : state_.names()) {
      list += ",\"" + name + "\"";
    }
    return list;
  });
  add("[SOURce:]DATA:VOLatile:FREE", {}, [this](std::string_view) {
    std::size_t free = state_.facts().memory_points;
    for (const std::string& name : state_.names()) {
      free -= state_.find(name)->points();
    }
    return fmt::format("{:+d}", static_cast<std::int64_t>(state_.has_room(0) ? free : 0));
  });
  add("[SOURce:]DATA:ATTRibute:POINts", {}, [this](std::string_view argument) {
    const GeneratorWaveform* const found =
        state_.find(argument.empty() ? state_.settings().waveform : unquoted(argument));
    return fmt::format("{:+d}", found == nullptr ? 0 : static_cast<int>(found->points()));
  });
  add(
      "FORMat:BORDer",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"NORMal", "SWAPped"});
        swapped_ = name.empty() ? swapped_ : name == "SWAPped";
      },
      [this](std::string_view) { return swapped_ ? "SWAP" : "NORM"; });
}

void Keysight::select(std::string_view argument) {
  const std::string name = unquoted(argument);
  if (upper(name) == kBuiltIn || upper(name) == "EXP_RISE") {
    change([](GeneratorSettings& next) { next.waveform.clear(); });
  } else if (state_.find(name) == nullptr) {
    error(785, "Specified arb waveform does not exist");
  } else {
    change([&](GeneratorSettings& next) { next.waveform = name; });
  }
}

// "name, values" or "name, #…": 16-bit codes up to ±32 767, or single-precision numbers up to ±1
// (guide, DATA:ARBitrary[:DAC]). "Specifying a waveform that is already loaded generates a
// 'Specified arb waveform already exists' error."
void Keysight::take_data(std::string_view argument, bool dac) {
  const auto comma = argument.find(',');
  const std::string name = unquoted(argument.substr(0, comma));
  if (comma == std::string_view::npos || name.empty()) {
    error(-109, "Missing parameter");
    return;
  }
  if (state_.find(name) != nullptr) {
    error(786, "Specified arb waveform already exists");
    return;
  }
  const double full_scale = dac ? 1.0 : 32767.0;
  std::vector<std::int16_t> codes;
  bool in_range = true;
  const auto take = [&](double value) {
    const double code = std::round(value * full_scale);
    in_range = in_range && std::abs(code) <= 32767.0;
    codes.push_back(in_range ? static_cast<std::int16_t>(code) : std::int16_t{0});
  };
  const std::string_view rest = left_trimmed(argument.substr(comma + 1));
  if (!rest.empty() && rest.front() == '#') {
    const auto bytes = block_of(rest);
    const std::size_t size = dac ? 2 : 4;
    if (!bytes || bytes->size() % size != 0) {
      error(-161, "Invalid block data");
      return;
    }
    for (std::size_t at = 0; at < bytes->size(); at += size) {
      char point[4];
      std::memcpy(point, bytes->data() + at, size);
      if (!swapped_) {
        std::reverse(point, point + size);
      }
      std::int16_t code = 0;
      float part = 0;
      std::memcpy(dac ? static_cast<void*>(&code) : &part, point, size);
      take(dac ? static_cast<double>(code) : static_cast<double>(part));
    }
  } else {
    for (const std::string_view field : fields_of(rest)) {
      const auto value = number_of(field);
      if (!value) {
        error(-104, "Data type error");
        return;
      }
      take(*value);
    }
  }
  if (!in_range || codes.size() < state_.facts().fewest_points) {
    error(-222, "Data out of range");
  } else if (codes.size() > state_.facts().most_points || !state_.has_room(codes.size())) {
    error(781, "Not enough memory to store new arb waveform; use DATA:VOLATILE:CLEAR");
  } else {
    state_.store({name, std::move(codes), 0.0, 1 / 32767.0});
    if (state_.faults().upload_switches_on) {
      change([](GeneratorSettings& next) { next.output_on = true; });
    }
  }
}

}  // namespace gsbench::emulation
