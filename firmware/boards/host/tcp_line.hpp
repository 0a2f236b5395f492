// Lines over TCP, such as that of an emulated UART.
#pragma once

#include "descriptor_line.hpp"

#include <string>
#include <utility>
#include <vector>

namespace gs::host {

// Connects to an address.
class TcpLine final : public DescriptorLine {
 public:
  // "127.0.0.1:5000", "[::1]:5000" or "localhost:5000"; a name is looked up at each attempt.
  explicit TcpLine(std::string address) : address_(std::move(address)) {}

 private:
  int connect(std::string& far_end, std::string& why) override;

  std::string address_;
};

// Waits at an address for one connection after another.
class ListeningLine final : public DescriptorLine {
 public:
  explicit ListeningLine(std::string address) : address_(std::move(address)) {}
  ~ListeningLine() override;

  // Listens, at each address of a name. If that fails for all, returns false with the reason in
  // `why`.
  bool listen(std::string& why);

 private:
  int connect(std::string& far_end, std::string& why) override;

  std::string address_;
  std::vector<int> listeners_;  // one for each address of a name
};

}  // namespace gs::host
