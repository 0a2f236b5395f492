#include "waveform_answer.hpp"

#include "text.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Error;
using drivers::Result;

namespace {

constexpr std::size_t kLongestHeader = 1000;

}  // namespace

Result<std::optional<WaveformHeader>> waveform_header(const std::vector<std::uint8_t>& received) {
  const std::string text(
      received.begin(),
      received.begin() + static_cast<std::ptrdiff_t>(std::min(received.size(), kLongestHeader)));
  constexpr const char* kData = "WAVEDATA,";
  const std::size_t data = text.find(kData);
  if (data == std::string::npos) {
    if (received.size() > kLongestHeader || text.find('\n') != std::string::npos) {
      return Error{fmt::format("\"{}\" has no WAVEDATA", printable(text))};
    }
    return std::optional<WaveformHeader>();
  }
  const Result<std::string> length = value_in(text.substr(0, data) + "WAVEDATA", "LENGTH");
  if (!length.ok()) {
    return Error{length.error()};
  }
  const Result<double> bytes = number_in(length.value(), "B");
  if (!bytes.ok() || bytes.value() < 0.0 || bytes.value() > 1e9) {
    return Error{fmt::format("\"{}\" is no number of bytes", printable(length.value()))};
  }
  return std::optional<WaveformHeader>(
      {data + std::string(kData).size(), static_cast<std::size_t>(bytes.value())});
}

}  // namespace gsbench::scpi
