// The program that runs an outlet's firmware, and the bench's end of its serial line.
#pragma once

#include <test_support/demand.hpp>

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <emulation/child.hpp>
#include <emulation/listening.hpp>
#include <emulation/null_modem.hpp>
#include <transport/transport.hpp>

namespace gs::test {

// Timeout of every wait.
constexpr std::chrono::seconds kPatience{30};

class Machine {
 public:
  // `words`: program and arguments; qemu-system-arm, whose first serial port is the line, or
  // gs-outlet.
  explicit Machine(std::vector<std::string> words);
  ~Machine() { kill(); }
  Machine(const Machine&) = delete;
  Machine& operator=(const Machine&) = delete;

  gsbench::transport::Transport& line() { return *line_; }
  // The transport port on which qemu listens for a debugger.
  std::string debugger() const;
  // Like a loss of power: no signal handler runs.
  void kill() { child_->kill(); }

 private:
  std::unique_ptr<gsbench::emulation::NullModem> cable_ =
      gsbench::test::demand(gsbench::emulation::NullModem::create());
  gsbench::emulation::LoopbackPort debugger_ =
      gsbench::test::demand(gsbench::emulation::LoopbackPort::reserve());
  std::unique_ptr<gsbench::transport::Transport> line_ =
      gsbench::transport::make_transport(cable_->bench_end());
  std::optional<gsbench::emulation::Child> child_;
};

}  // namespace gs::test
