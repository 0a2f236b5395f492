// An emulated generator with a client, and a look at its output, for tests.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <emulation/generator.hpp>
#include <transport/transport.hpp>

namespace gsbench::test {

// A block with the header of IEEE 488.2.
inline std::string block(const std::string& bytes) {
  const std::string length = std::to_string(bytes.size());
  return "#" + std::to_string(length.size()) + length + bytes;
}

// Codes as 16-bit numbers.
inline std::string bytes_of(const std::vector<std::int16_t>& codes, bool big_endian = false) {
  std::string bytes;
  for (const std::int16_t code : codes) {
    const char low = static_cast<char>(code & 0xff);
    const char high = static_cast<char>((code >> 8) & 0xff);
    bytes += big_endian ? high : low;
    bytes += big_endian ? low : high;
  }
  return bytes;
}

class GeneratorClient {
 public:
  explicit GeneratorClient(const std::string& port) : transport_(transport::make_transport(port)) {
    connect();
  }
  bool connect() { return transport_->open().ok(); }
  bool is_open() const { return transport_->is_open(); }

  void send(const std::string& bytes) {
    const std::vector<std::uint8_t> sent(bytes.begin(), bytes.end());
    EXPECT_TRUE(transport_->send(sent).ok()) << bytes.substr(0, 80);
  }
  void say(const std::string& line) { send(line + "\n"); }

  // The next `count` bytes, or up to a newline, which is taken away. Empty if the far end hung up
  // or sends nothing for the time given.
  std::string line(std::chrono::milliseconds patience = std::chrono::seconds(20)) {
    return taken([&] { return received_.find('\n') + 1; }, patience, 1);
  }
  std::string bytes(std::size_t count) {
    return taken([&] { return received_.size() < count ? 0 : count; }, std::chrono::seconds(20), 0);
  }
  std::string ask(const std::string& query) {
    say(query);
    return line();
  }
  // Whether the far end closes the connection.
  bool hangs_up() {
    std::vector<std::uint8_t> ignored;
    const auto end = transport::Clock::now() + std::chrono::seconds(20);
    while (transport::Clock::now() < end) {
      if (!transport_->receive(ignored, end).ok()) {
        return true;
      }
    }
    return false;
  }

 private:
  template <class Size>
  std::string taken(Size size, std::chrono::milliseconds patience, std::size_t cut) {
    const auto end = transport::Clock::now() + patience;
    std::size_t wanted = size();
    while (wanted == 0 && transport::Clock::now() < end) {
      std::vector<std::uint8_t> more;
      if (!transport_->receive(more, end).ok()) {
        break;
      }
      received_.append(more.begin(), more.end());
      wanted = size();
    }
    std::string result = received_.substr(0, wanted == 0 ? 0 : wanted - cut);
    received_.erase(0, wanted);
    return result;
  }

  std::unique_ptr<transport::Transport> transport_;
  std::string received_;
};

// A generator whose clock starts in an hour: until then, commands take effect at the end of what is
// rendered, so that a test decides the step.
class GeneratorBench {
 public:
  explicit GeneratorBench(emulation::GeneratorModel model, double clock_ppm = 0.0) {
    emulation::GeneratorOptions options;
    options.model = model;
    options.clock_ppm = clock_ppm;
    options.time.start = std::chrono::steady_clock::now() + std::chrono::hours(1);
    generator = emulation::Generator::start(options).take();
    generator->render(0, 0, nullptr);
    client = std::make_unique<GeneratorClient>(generator->port());
  }

  // The next `steps` of the output.
  std::vector<double> output(std::size_t steps) {
    std::vector<float> volts(steps);
    generator->render(step, steps, volts.data());
    step += static_cast<std::int64_t>(steps);
    return {volts.begin(), volts.end()};
  }
  double mean(std::size_t steps) {
    const std::vector<double> volts = output(steps);
    return std::accumulate(volts.begin(), volts.end(), 0.0) / static_cast<double>(steps);
  }
  // Sends commands, and returns when they have been executed.
  void say(const std::vector<std::string>& lines) {
    for (const std::string& line : lines) {
      client->say(line);
    }
    EXPECT_EQ(client->ask("*OPC?"), "1");
  }
  std::string ask(const std::string& query) { return client->ask(query); }
  emulation::GeneratorSettings settings() const { return generator->settings(); }

  std::unique_ptr<emulation::Generator> generator;
  std::unique_ptr<GeneratorClient> client;
  std::int64_t step = 0;
};

}  // namespace gsbench::test
