#include "generator_rigol.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

// The guide has packets of up to 16 384 points; two public drivers state that 8192 points, 16 384
// bytes, are the most that works. So does this one.
constexpr std::size_t kMostPacketBytes = 16384;
constexpr std::string_view kVolatile = "VOLATILE";

}  // namespace

void Rigol::add_data() {
  add("[SOURce:][TRACe:]DATA:DAC16", [this](std::string_view argument) { take_packet(argument); },
      {});
  add("[SOURce:][TRACe:]DATA[:DATA]", [this](std::string_view argument) { take_values(argument); },
      {});
  add("[SOURce:][TRACe:]DATA:POINts", {}, [this](std::string_view argument) {
    const GeneratorWaveform* const found =
        upper(argument) == kVolatile ? state_.find(std::string(kVolatile)) : nullptr;
    return std::to_string(found == nullptr ? 0 : found->points());
  });
  add(
      "[SOURce:][TRACe:]DATA:POINts:INTerpolate",
      [this](std::string_view argument) {
        const auto name = one_of(argument, {"LINear", "OFF"});
        if (!name.empty()) {
          change([&](GeneratorSettings& next) {
            next.between = name == "OFF" ? Between::kHold : Between::kLine;
          });
        }
      },
      [this](std::string_view) {
        return state_.settings().between == Between::kLine ? "LINEAR" : "OFF";
      });
  // The syntax of the DG1000 and DG4000 is known, and refused.
  for (const std::string_view older :
       {"[SOURce:][TRACe:]DATA:DAC", "[SOURce:]FUNCtion:USER", "[SOURce:]DATA:LOAD"}) {
    add(older, [this](std::string_view) { error(-220, "Parameter error"); }, {});
  }
}

// "VOLATILE,CON|END,#5…": little-endian codes 0 … 3FFF.
void Rigol::take_packet(std::string_view argument) {
  const auto comma = argument.find(',');
  const auto second = comma == std::string_view::npos ? comma : argument.find(',', comma + 1);
  if (second == std::string_view::npos || upper(argument.substr(0, comma)) != kVolatile) {
    error(-220, "Parameter error");
    return;
  }
  const std::string flag = upper(trimmed(argument.substr(comma + 1, second - comma - 1)));
  const auto bytes = block_of(left_trimmed(argument.substr(second + 1)));
  if (!bytes || bytes->size() % 2 != 0 || (flag != "CON" && flag != "END")) {
    error(-220, "Parameter error");
    return;
  }
  if (arrived_ < busy_until_) {
    return;  // lost, and not reported
  }
  // Users pause 50 to 200 ms between packets, or wait for *OPC?, because packets that follow each
  // other at once are lost.
  busy_until_ = arrived_ + std::llround(state_.packet_pause_s() * TrueTime::kRate_hz);
  if (bytes->size() > kMostPacketBytes || bytes->size() / 2 < state_.facts().fewest_points) {
    error(bytes->size() > kMostPacketBytes ? -223 : -220,
          bytes->size() > kMostPacketBytes ? "Too much data" : "Parameter error");
    return;
  }
  std::vector<std::int16_t> codes = packets_;
  for (std::size_t i = 0; i < bytes->size(); i += 2) {
    const auto low = static_cast<unsigned char>((*bytes)[i]);
    const auto high = static_cast<unsigned char>((*bytes)[i + 1]);
    const int code = low | high << 8;
    if (code > kHighestCode) {
      error(-222, "Data out of range");
      return;
    }
    codes.push_back(static_cast<std::int16_t>(code));
  }
  if (flag == "CON") {
    packets_ = std::move(codes);
  } else {
    packets_.clear();
    end_upload(std::move(codes));
  }
}

// "VOLATILE,0.1,-0.5,…": −1 … 1.
void Rigol::take_values(std::string_view argument) {
  const auto fields = fields_of(argument);
  if (fields.size() < 2 || upper(fields[0]) != kVolatile) {
    error(-220, "Parameter error");
    return;
  }
  std::vector<std::int16_t> codes;
  for (std::size_t i = 1; i < fields.size(); ++i) {
    const auto value = number_of(fields[i]);
    if (!value || std::abs(*value) > 1) {
      error(-222, "Data out of range");
      return;
    }
    codes.push_back(static_cast<std::int16_t>(std::lround((*value + 1) / 2 * kHighestCode)));
  }
  end_upload(std::move(codes));
}

// The output switches to the waveform by itself, in SRATE mode, and leaves burst mode. It is not
// switched on.
void Rigol::end_upload(std::vector<std::int16_t> codes) {
  const std::size_t points = codes.size();
  state_.forget_waveforms();
  if (points > state_.facts().most_points || !state_.has_room(points)) {
    error(-321, "Out of memory");
    return;
  }
  const double zero = kHighestCode / 2.0;
  state_.store({std::string(kVolatile), std::move(codes), zero, 1 / zero});
  change([&](GeneratorSettings& next) {
    next.function = GeneratorFunction::kArbitrary;
    next.waveform = kVolatile;
    next.point_rate = PointRate::kSampleRate;
    next.burst_on = false;
    next.output_on = next.output_on || state_.faults().upload_switches_on;
  });
}

}  // namespace gsbench::emulation
