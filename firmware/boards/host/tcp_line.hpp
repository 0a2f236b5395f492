// Lines over TCP, such as that of an emulated UART.
#pragma once

#include "descriptor_line.hpp"

#include <string>
#include <utility>

namespace gs::host {

// Connects to an address.
class TcpLine final : public DescriptorLine {
 public:
  explicit TcpLine(std::string address) : address_(std::move(address)) {}  // "127.0.0.1:5000"

 private:
  int connect(std::string& why) override;

  std::string address_;
};

// Waits at an address for one connection after another.
class ListeningLine final : public DescriptorLine {
 public:
  explicit ListeningLine(std::string address) : address_(std::move(address)) {}
  ~ListeningLine() override;

  // Listens. If that fails, returns false with the reason in `why`.
  bool listen(std::string& why);

 private:
  int connect(std::string& why) override;

  std::string address_;
  int listener_ = -1;
};

}  // namespace gs::host
