// A head on a host, with a bench that numbers its messages.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <head/head.hpp>

namespace gs::head::test {

using Bytes = std::vector<std::uint8_t>;

constexpr std::uint32_t kCountsPerSample = 10500;           // as on the board: 84 MHz
constexpr std::uint32_t kBlockCodes = kCodeRate_hz / 1000;  // of a millisecond

Hardware hardware();

template <class Message>
Bytes encoded(const Message& message, std::uint32_t number) {
  Bytes bytes(kLongestMessage);
  bytes.resize(encode(message, number, bytes.data(), bytes.size()));
  return bytes;
}

// A message of the given samples.
Samples samples_message(std::uint64_t first_sample, const std::vector<std::int16_t>& samples);
// Sample n of a stream that a test can recognise: all different for a while, within full scale.
std::int16_t sample_of_stream(std::uint64_t n);
Samples stream(std::uint64_t first_sample, std::uint16_t count);
// The codes of that stream, computed by itself, from sample 0 on.
std::vector<std::uint16_t> codes_of_stream(std::size_t codes);

class Rig {
 public:
  // Sends with the next number.
  template <class Message>
  void send(const Message& message) {
    send(message, number_++);
  }
  template <class Message>
  void send(const Message& message, std::uint32_t number) {
    send(encoded(message, number));
  }
  void send(const Bytes& bytes);
  // `Ping` uses no number.
  void ping(std::uint32_t token = 0) { send(Ping{token}, number_); }

  // Identified, armed for run 7; messages received so far are forgotten.
  void arm();
  // Armed, `samples` of the stream sent and played; no code is made yet.
  void play(std::uint16_t samples);

  // Makes the codes of so many milliseconds, and receives the head's messages after each.
  void run_ms(std::size_t ms);
  // Makes codes without receiving messages.
  void make_codes(std::size_t codes);
  void receive();

  // Number of the next message to be sent.
  std::uint32_t number() const { return number_; }
  void set_number(std::uint32_t number) { number_ = number; }

  // Count of code i at the output.
  static std::uint64_t count_of(std::uint64_t code) { return code * kCountsPerSample / 8; }
  std::uint64_t now() const { return count_of(codes_.size()); }

  // The messages received, of one kind.
  template <class Message>
  std::vector<Message> received() const {
    std::vector<Message> found;
    for (const Bytes& bytes : received_) {
      Message message;
      if (decode(bytes.data(), bytes.size(), message)) {
        found.push_back(message);
      }
    }
    return found;
  }
  const std::vector<Bytes>& received_bytes() const { return received_; }
  void forget() { received_.clear(); }
  // The status now: pings, receives.
  Status status();

  Head& head() { return head_; }
  // All codes so far.
  const std::vector<std::uint16_t>& codes() const { return codes_; }
  // True if none but mid-scale was made since this code.
  bool off_since(std::size_t code) const;

 private:
  Head head_{hardware()};
  std::uint32_t number_ = 0;
  std::vector<std::uint16_t> codes_;
  std::vector<Bytes> received_;
};

}  // namespace gs::head::test
