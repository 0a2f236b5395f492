#include <head_test/rig.hpp>

#include <algorithm>
#include <cstring>

namespace gs::head::test {

Hardware hardware() {
  Hardware hardware;
  std::strcpy(hardware.board, "stm32f405");
  for (std::size_t i = 0; i < kUniqueIdBytes; ++i) {
    hardware.unique_id[i] = static_cast<std::uint8_t>(0xA0 + i);
  }
  hardware.build = 0xDEADBEEFU;
  hardware.flags = kCrystalRuns;
  hardware.counts_per_sample = kCountsPerSample;
  return hardware;
}

Samples samples_message(std::uint64_t first_sample, const std::vector<std::int16_t>& samples) {
  Samples message;
  message.first_sample = first_sample;
  message.count = static_cast<std::uint16_t>(samples.size());
  std::copy(samples.begin(), samples.end(), message.samples);
  return message;
}

std::int16_t sample_of_stream(std::uint64_t n) {
  return static_cast<std::int16_t>(static_cast<std::int64_t>((n * 7919 + 12345) % 57000) - 28500);
}

Samples stream(std::uint64_t first_sample, std::uint16_t count) {
  Samples message;
  message.first_sample = first_sample;
  message.count = count;
  for (std::uint16_t i = 0; i < count; ++i) {
    message.samples[i] = sample_of_stream(first_sample + i);
  }
  return message;
}

std::vector<std::uint16_t> codes_of_stream(std::size_t codes) {
  std::vector<std::uint16_t> out;
  int remainder = 0;
  for (std::size_t i = 0; i < codes; ++i) {
    const int phase = static_cast<int>(i % 8);
    const int from = sample_of_stream(i / 8);
    const int to = sample_of_stream(i / 8 + 1);
    // In 1/128 of a step.
    const int wanted = from * (8 - phase) + to * phase + remainder;
    int code = (wanted + 64) / 128;
    code -= wanted + 64 < 0 && (wanted + 64) % 128 != 0 ? 1 : 0;  // floor
    remainder = wanted - 128 * code;
    out.push_back(static_cast<std::uint16_t>(2048 + code));
  }
  return out;
}

void Rig::send(const Bytes& bytes) {
  head_.take(bytes.data(), bytes.size());
}

void Rig::arm() {
  send(Identify{});
  send(Arm{7});
  receive();
  forget();
}

void Rig::play(std::uint16_t samples) {
  arm();
  for (std::uint16_t sent = 0; sent < samples;) {
    const auto count =
        static_cast<std::uint16_t>(std::min<std::size_t>(kLongestSamples, samples - sent));
    send(stream(sent, count));
    sent = static_cast<std::uint16_t>(sent + count);
  }
  send(Play{samples});
}

void Rig::run_ms(std::size_t ms) {
  for (std::size_t i = 0; i < ms; ++i) {
    make_codes(kBlockCodes);
    receive();
  }
}

void Rig::make_codes(std::size_t codes) {
  const std::size_t before = codes_.size();
  codes_.resize(before + codes);
  head_.next_codes(count_of(before), codes_.data() + before, codes);
}

void Rig::receive() {
  for (;;) {
    Bytes bytes(kLongestUplink);
    bytes.resize(head_.next_message(now(), bytes.data(), bytes.size()));
    if (bytes.empty()) {
      return;
    }
    received_.push_back(bytes);
  }
}

Status Rig::status() {
  ping();
  receive();
  return received<Status>().back();
}

bool Rig::off_since(std::size_t code) const {
  return std::all_of(codes_.begin() + static_cast<std::ptrdiff_t>(code), codes_.end(),
                     [](std::uint16_t one) { return one == kMidScale; });
}

}  // namespace gs::head::test
