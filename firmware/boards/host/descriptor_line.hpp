// A line over a file descriptor: a serial port or TCP. If the connection is lost, serve() opens it
// again.
#pragma once

#include "line.hpp"

#include <chrono>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace gs::host {

class DescriptorLine : public Line {
 public:
  // No more bytes are read while so many wait; what one read and a frame add may come on top.
  static constexpr std::size_t kMostReceivedBytes = 8192;

  ~DescriptorLine() override { close(); }
  DescriptorLine() = default;
  DescriptorLine(const DescriptorLine&) = delete;
  DescriptorLine& operator=(const DescriptorLine&) = delete;

  // Opens the line, and may block meanwhile. If that fails, returns false with the reason in `why`.
  bool open(std::string& why);

  // Returns false without a connection or if the send buffer is full: the bytes are then lost.
  bool send(const std::uint8_t* bytes, std::size_t count) override;
  void serve() override;
  int descriptor() const override { return descriptor_; }
  bool wants_to_write() const override { return !to_send_.empty(); }
  std::uint32_t take_unsent() override { return std::exchange(unsent_, 0); }

 protected:
  // A descriptor that does not block; -1: none, with the reason in `why`, or none yet: while
  // is_connecting(), it is called again at each serve(). Sets `far_end`, for
  // people: "/dev/ttyUSB0".
  virtual int connect(std::string& far_end, std::string& why) = 0;

 private:
  void close();
  void receive();
  void take(const std::uint8_t* bytes, std::size_t count);
  void transmit();

  int descriptor_ = -1;
  std::string far_end_;                // of the newest connection
  std::vector<std::uint8_t> partial_;  // the beginning of a frame, which waits for its end
  std::vector<std::uint8_t> to_send_;
  std::uint32_t unsent_ = 0;
  std::chrono::steady_clock::time_point next_attempt_;
};

}  // namespace gs::host
