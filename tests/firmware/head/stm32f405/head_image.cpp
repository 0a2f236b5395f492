#include "head_image.hpp"

#include <algorithm>

namespace gs::head::test {
namespace {

using gsbench::test::demand;

constexpr std::uint32_t kRam = 0x20000000U;
constexpr std::size_t kRamBytes = 32768;
constexpr std::uint32_t kUnusedRam = 0x20010000U;  // for the inserted code

// push {r0-r7}; mrs r5, primask; mrs r6, apsr; cpsie i; ldr r0, timer; ldr r1, count;
// ldr r2, times; ldr r3, set_pending; ldr r4, bit; ldr r7, step; push {r7}; ldr r7, prescaler;
// str r7, [r0, #4]; ldr r7, [sp]; 1: str r1, [r0]; str r4, [r3]; dsb; isb; add r1, r7;
// subs r2, #1; bne 1b; pop {r7}; msr apsr, r6; msr primask, r5; pop {r0-r7}; ldr pc, back; nop
constexpr std::uint16_t kInserted[] = {
    0xB4FF, 0xF3EF, 0x8510, 0xF3EF, 0x8600, 0xB662, 0x480D, 0x490E, 0x4A0E, 0x4B0F, 0x4C0F, 0x4F10,
    0xB480, 0x4F10, 0x6047, 0x9F00, 0x6001, 0x601C, 0xF3BF, 0x8F4F, 0xF3BF, 0x8F6F, 0x4439, 0x3A01,
    0xD1F6, 0xBC80, 0xF386, 0x8800, 0xF385, 0x8810, 0xBCFF, 0xF8DF, 0xF020, 0xBF00};

void append(Bytes& bytes, std::uint32_t value, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
}

}  // namespace

void HeadImage::send_bytes(const Bytes& bytes) {
  demand(machine_.line().send(bytes));
}

void HeadImage::read() {
  Bytes received;
  demand(machine_.line().receive(
      received, gsbench::transport::Clock::now() + std::chrono::milliseconds(100)));
  for (const std::uint8_t byte : received) {
    const auto taken = reader_.take(byte);
    if (taken == wire::FrameReader::Taken::kBadFrame) {
      throw std::runtime_error("the head sent a bad frame");
    }
    if (taken == wire::FrameReader::Taken::kMessage) {
      messages_.emplace_back(reader_.message(), reader_.message() + reader_.size());
    }
  }
}

Status HeadImage::status(std::uint32_t next_number) {
  send(Ping{++token_}, next_number);
  Status status;
  while (status.echo != token_) {
    status = wait_for<Status>();
  }
  return status;
}

std::uint32_t HeadImage::play(std::uint16_t samples) {
  wait_for<Hello>();
  send(Identify{}, 0);
  send(Arm{7}, 1);
  std::uint32_t number = 2;
  for (std::uint64_t first = 0; first < samples; first += kLongestSamples) {
    send(stream(first, kLongestSamples), number++);
  }
  send(Play{samples}, number++);
  if (status(number).state != State::kArmed) {
    throw std::runtime_error("the head is not armed");
  }
  return number;
}

void HeadImage::make_codes(std::uint32_t ms, std::uint32_t offset_counts) {
  interrupt(kDma1Stream5, ms, (blocks_ + 1) * kBlock_counts + offset_counts, kBlock_counts);
  blocks_ += ms;
}

void HeadImage::interrupt(std::uint32_t number, std::uint32_t times, std::uint32_t count,
                          std::uint32_t step) {
  constexpr std::uint32_t kTimer2Count = 0x40000024U;
  constexpr std::uint32_t kSetPending = 0xE000E200U;
  constexpr std::uint32_t kPrescaler = 0xFFFFU;  // the timer hardly moves by itself
  {
    gs::test::Debugger debugger(machine_);
    const std::uint32_t back = debugger.program_counter() | 1U;
    Bytes bytes;
    for (const std::uint16_t half : kInserted) {
      append(bytes, half, 2);
    }
    for (const std::uint32_t word : {kTimer2Count, count, times, kSetPending + 4 * (number / 32),
                                     1U << (number % 32), step, kPrescaler, back}) {
      append(bytes, word, 4);
    }
    debugger.write(kUnusedRam, bytes);
    debugger.go_to(kUnusedRam);
  }
  // The ping wakes the processor; the main loop answers it after the inserted code.
  static_cast<void>(status(0));
}

std::vector<std::uint8_t> HeadImage::memory(std::uint32_t address, std::size_t size) {
  return gs::test::Debugger(machine_).memory(address, size);
}

std::uint32_t HeadImage::find_in_memory(const std::vector<std::uint16_t>& codes) {
  Bytes wanted;
  for (const std::uint16_t code : codes) {
    append(wanted, code, 2);
  }
  const Bytes all = memory(kRam, kRamBytes);
  const auto found = std::search(all.begin(), all.end(), wanted.begin(), wanted.end());
  return found == all.end() ? 0 : kRam + static_cast<std::uint32_t>(found - all.begin());
}

}  // namespace gs::head::test
