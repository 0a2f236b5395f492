// The head's image in qemu's netduinoplus2. The emulated chip has memories, USARTs and timer 2. It
// has no clocks, so that the firmware finds no crystal; no unique id, DAC, DMA and captures. The
// interrupts of DMA and DAC are requested by code that a debugger inserts.
#pragma once

#include <cortex_m4/debugger.hpp>
#include <head_test/rig.hpp>

#include <stdexcept>

#include <gtest/gtest.h>

#include <wire/frame.hpp>

namespace gs::head::test {

constexpr std::uint32_t kDma1Stream5 = 16, kTim6Dac = 54;  // interrupts
constexpr std::uint32_t kBlock_counts = 16000;             // of timer 2, 16 MHz, for 1 ms

class HeadImage : public testing::Test {
 protected:
  void send_bytes(const Bytes& bytes);

  template <class Message>
  void send(const Message& message, std::uint32_t number) {
    const Bytes bytes = encoded(message, number);
    Bytes frame(wire::kLongestFrame);
    frame.resize(wire::frame(bytes.data(), bytes.size(), frame.data(), frame.size()));
    send_bytes(frame);
  }

  // The next message of this kind; those before it are dropped.
  template <class Message>
  Message wait_for() {
    const auto end = gsbench::transport::Clock::now() + gs::test::kPatience;
    for (;;) {
      while (!messages_.empty()) {
        const Bytes bytes = messages_.front();
        messages_.erase(messages_.begin());
        Message message;
        if (decode(bytes.data(), bytes.size(), message)) {
          return message;
        }
      }
      if (gsbench::transport::Clock::now() > end) {
        throw std::runtime_error("timeout while waiting for a message of the head");
      }
      read();
    }
  }

  // A status after all that was sent before. `next_number`: of the bench's next message.
  Status status(std::uint32_t next_number);

  // Identified and armed; so many samples sent, and play. Returns the next number.
  std::uint32_t play(std::uint16_t samples);
  // Makes codes of so many further milliseconds, while the main loop stands still.
  // `offset_counts`: of the interrupts, from the end of their blocks; modulo 2^32.
  void make_codes(std::uint32_t ms, std::uint32_t offset_counts = 50);
  // Calls the handler of an interrupt, with timer 2 at this count.
  void interrupt(std::uint32_t number, std::uint32_t count) { interrupt(number, 1, count, 0); }

  std::vector<std::uint8_t> memory(std::uint32_t address, std::size_t size);
  // Where the image's memory contains these codes, one after the other; 0: nowhere.
  std::uint32_t find_in_memory(const std::vector<std::uint16_t>& codes);

 private:
  void read();
  // `step`: timer 2 is this much further at each of the calls.
  void interrupt(std::uint32_t number, std::uint32_t times, std::uint32_t count,
                 std::uint32_t step);

  gs::test::Machine machine_{
      {"qemu-system-arm", "-M", "netduinoplus2", "-kernel", GSBENCH_HEAD_IMAGE}};
  wire::FrameReader reader_;
  std::vector<Bytes> messages_;
  std::uint32_t token_ = 0;
  std::uint32_t blocks_ = 0;
};

}  // namespace gs::head::test
