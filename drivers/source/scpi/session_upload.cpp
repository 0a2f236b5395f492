// The upload of the waveform, and its verification.
#include "codes.hpp"
#include "session.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Result;
using drivers::Status;

Status Session::clear_memory() {
  if (instrument_.dialect.clear.empty()) {
    return Done{};
  }
  if (Status sent = connection_.send(text(instrument_.dialect.clear)); !sent.ok()) {
    return sent;
  }
  if (Status paused = connection_.pause(instrument_.timing.packet_s); !paused.ok()) {
    return paused;
  }
  return instrument_.has(Quirk::kUploadSwitchesOn) ? switch_output(false) : Status(Done{});
}

Status Session::upload(const Plan& plan, const source::Progress& progress) {
  if (instrument_.format.block == Block::kPackets) {
    return upload_packets(plan, progress);
  }
  const std::vector<std::uint8_t> bytes =
      bytes_of(plan.codes.data(), plan.codes.size(), instrument_);
  std::string header = text(instrument_.dialect.upload);
  if (instrument_.format.block == Block::kBlock) {
    const std::string count = std::to_string(bytes.size());
    header += fmt::format("#{}{}", count.size(), count);
  }
  return connection_.send_block(header, bytes, [&](std::size_t sent) {
    if (progress) {
      progress(static_cast<double>(sent) / static_cast<double>(bytes.size()));
    }
  });
}

Status Session::upload_packets(const Plan& plan, const source::Progress& progress) {
  const std::size_t total = plan.codes.size();
  const auto most = static_cast<std::size_t>(instrument_.memory.packet_points);
  const auto fewest = static_cast<std::size_t>(instrument_.memory.fewest_points);
  for (std::size_t at = 0; at < total;) {
    std::size_t count = std::min(most, total - at);
    // The last packet must not be too short.
    if (const std::size_t rest = total - at - count; rest > 0 && rest < fewest) {
      count -= fewest - rest;
    }
    const bool last = at + count == total;
    const std::vector<std::uint8_t> bytes = bytes_of(plan.codes.data() + at, count, instrument_);
    const std::string size = std::to_string(bytes.size());
    const std::string header =
        filled(text(instrument_.dialect.upload),
               {{"part", last ? instrument_.dialect.last_part : instrument_.dialect.more_part}}) +
        fmt::format("#{}{}", size.size(), size);
    if (Status sent = connection_.send_block(header, bytes, {}); !sent.ok()) {
      return sent;
    }
    if (Status paused = connection_.pause(instrument_.timing.packet_s); !paused.ok()) {
      return paused;
    }
    at += count;
    if (progress) {
      progress(static_cast<double>(at) / static_cast<double>(total));
    }
  }
  return Done{};
}

Status Session::verify(const Plan& plan) {
  if (Status clean = expect_no_error("the upload"); !clean.ok()) {
    return clean;
  }
  if (instrument_.verification != Verification::kReadBack) {
    return Done{};
  }
  const Result<std::vector<std::uint8_t>> read =
      connection_.ask_waveform(text(instrument_.dialect.read_back));
  if (!read.ok()) {
    return error(fmt::format("the waveform cannot be read back: {}", read.error()));
  }
  const std::vector<std::uint8_t> sent =
      bytes_of(plan.codes.data(), plan.codes.size(), instrument_);
  const std::vector<std::uint8_t>& stored = read.value();
  if (stored.size() != sent.size()) {
    return error(fmt::format("the waveform was not stored as sent: {} bytes instead of {}",
                             stored.size(), sent.size()));
  }
  const auto differs = std::mismatch(sent.begin(), sent.end(), stored.begin());
  if (differs.first != sent.end()) {
    return error(
        fmt::format("the waveform was not stored as sent: byte {} is 0x{:02X} instead of "
                    "0x{:02X}",
                    differs.first - sent.begin(), *differs.second, *differs.first));
  }
  return Done{};
}

}  // namespace gsbench::scpi
