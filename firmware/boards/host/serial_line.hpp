// A serial line of this machine. A line that is not there, or goes away, is tried again.
#pragma once

#include "line.hpp"

#include <chrono>
#include <deque>
#include <string>
#include <vector>

namespace gs::host {

class SerialLine final : public Line {
 public:
  explicit SerialLine(std::string path) : path_(std::move(path)) {}
  ~SerialLine() override { close(); }

  // False, with the reason, where it is no serial line or not there.
  bool open(std::string& why);

  // False where so much waits already that it would only grow: the message is lost.
  bool send(const std::uint8_t* bytes, std::size_t count) override;
  bool take_byte(std::uint8_t& byte) override;
  void serve() override;
  int descriptor() const override { return descriptor_; }
  bool wants_to_write() const override { return !to_send_.empty(); }

 private:
  void close();
  void receive();
  void transmit();

  std::string path_;
  int descriptor_ = -1;
  std::deque<std::uint8_t> received_;
  std::deque<std::uint8_t> to_send_;
  std::chrono::steady_clock::time_point next_attempt_;
};

}  // namespace gs::host
