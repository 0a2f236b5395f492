#include "generator_scpi.hpp"
#include "generator_siglent.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace gsbench::emulation {

namespace {

constexpr std::string_view kWaveData = "WAVEDATA,";

// Where the bytes of a waveform start; npos if it is no upload.
std::size_t data_start(std::string_view text) {
  constexpr std::size_t kLongestHeader = 400;
  const auto found = upper(text.substr(0, kLongestHeader)).find(kWaveData);
  return found == std::string::npos ? found : found + kWaveData.size();
}

}  // namespace

// On TCP a message ends at the first 0x0A, also within the bytes of a waveform.
std::size_t Siglent::message_size(std::string_view bytes) {
  const auto newline = bytes.find('\n', std::min(scanned_, bytes.size()));
  scanned_ = newline == std::string_view::npos ? bytes.size() : 0;
  return newline == std::string_view::npos ? 0 : newline + 1;
}

std::size_t Siglent::text_size(std::string_view message) const {
  return std::min(data_start(message), trimmed(message).size());
}

// A name that is not stored is ignored. The function stays: BSWV WVTP,ARB selects it.
void Siglent::select(std::string_view argument) {
  const auto fields = fields_of(argument);
  GeneratorSettings next = state_.settings();
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    if (upper(fields[i]) == "NAME" && state_.find(unquoted(fields[i + 1])) != nullptr) {
      next.waveform = unquoted(fields[i + 1]);
    } else if (upper(fields[i]) == "INDEX") {
      next.waveform.clear();
    }
  }
  state_.set(next);
}

// Codes of 16 bits, little endian, +32767 is half the amplitude (guide, section WVDT). What came
// before a 0x0A is stored without a sign; so is less than LENGTH. What does not fit is not stored.
void Siglent::store(std::string_view argument) {
  const std::size_t data = data_start(argument);
  if (data == std::string::npos) {
    return;
  }
  std::string_view bytes = argument.substr(data);
  std::string name;
  const auto fields = fields_of(argument.substr(0, data - kWaveData.size()));
  for (std::size_t i = 0; i + 1 < fields.size(); i += 2) {
    if (upper(fields[i]) == "WVNM") {
      name = unquoted(fields[i + 1]);
    } else if (upper(fields[i]) == "LENGTH") {
      std::string length = upper(fields[i + 1]);
      double unit = 1;
      while (!length.empty() && (length.back() == 'B' || length.back() == 'K')) {
        unit = length.back() == 'K' ? 1024 : unit;
        length.pop_back();
      }
      const double said = number_of(length).value_or(1e9) * unit;
      if (said >= 0 && said < static_cast<double>(bytes.size())) {
        bytes = bytes.substr(0, static_cast<std::size_t>(said));
      }
    }
  }
  const std::size_t points = bytes.size() / 2;
  if (name.empty() || points < state_.facts().fewest_points ||
      points > state_.facts().most_points || !state_.has_room(points)) {
    return;
  }
  std::vector<std::int16_t> codes(points);
  for (std::size_t i = 0; i < points; ++i) {
    const auto low = static_cast<unsigned char>(bytes[2 * i]);
    const auto high = static_cast<unsigned char>(bytes[2 * i + 1]);
    codes[i] = static_cast<std::int16_t>(low | high << 8);
  }
  state_.store({name, std::move(codes), 0.0, 1 / 32767.0});
}

// "WVDT? USER,name" has no answer if there is no such waveform. Else: fields, codes, a newline.
std::string Siglent::read_back(std::string_view argument) const {
  const auto fields = fields_of(argument);
  const GeneratorWaveform* const found =
      fields.size() == 2 && upper(fields[0]) == "USER" ? state_.find(unquoted(fields[1])) : nullptr;
  if (found == nullptr) {
    return "";
  }
  std::string text = fmt::format(
      "WVDT WVNM,{},LENGTH,{}B,TYPE,5,FREQ,1000.000000000,AMPL,4.000000,OFST,0.000000,"
      "PHASE,0.000000000,WAVEDATA,",
      found->name(), 2 * found->points());
  for (const std::int16_t code : found->codes()) {
    text += static_cast<char>(code & 0xff);
    text += static_cast<char>((code >> 8) & 0xff);
  }
  return text;
}

}  // namespace gsbench::emulation
