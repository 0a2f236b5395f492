// A line over TCP, such as that of an emulated UART. If the connection is lost, serve() reconnects.
#pragma once

#include "line.hpp"

#include <chrono>
#include <string>
#include <vector>

namespace gs::host {

class TcpLine final : public Line {
 public:
  explicit TcpLine(std::string address) : address_(std::move(address)) {}  // "127.0.0.1:5000"
  ~TcpLine() override { close(); }

  // Connects, and blocks meanwhile. If the connection fails, returns false with the reason in
  // `why`.
  bool open(std::string& why);

  // Returns false without a connection or if the send buffer is full: the bytes are then lost.
  bool send(const std::uint8_t* bytes, std::size_t count) override;
  void serve() override;
  int descriptor() const override { return descriptor_; }
  bool wants_to_write() const override { return !to_send_.empty(); }

 private:
  void close();
  void receive();
  void transmit();

  std::string address_;
  int descriptor_ = -1;
  std::vector<std::uint8_t> to_send_;
  std::chrono::steady_clock::time_point next_attempt_;
};

}  // namespace gs::host
