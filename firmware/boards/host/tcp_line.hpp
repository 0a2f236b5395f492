// Lines over TCP, such as that of an emulated UART.
#pragma once

#include "attempt.hpp"
#include "descriptor_line.hpp"

#include <string>
#include <utility>
#include <vector>

namespace gs::host {

// Connects to an address: for the first time in open(), which waits for it; later in a thread.
class TcpLine final : public DescriptorLine {
 public:
  // "127.0.0.1:5000", "[::1]:5000" or "localhost:5000"; a name is looked up at each attempt.
  explicit TcpLine(std::string address) : address_(std::move(address)) {}

  bool is_connecting() const override { return attempt_.running(); }

 private:
  struct Outcome {
    int descriptor = -1;
    std::string why;
  };

  static Outcome connect_to(const std::string& address);
  int connect(std::string& far_end, std::string& why) override;

  std::string address_;
  bool was_connected_ = false;
  Attempt<Outcome> attempt_;
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
