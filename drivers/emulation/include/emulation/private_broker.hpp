// A Mosquitto of the bench's own on 127.0.0.1: nobody reads or commands an outlet through it
// without its certificate, a password and the leave of its access list. It ends with its owner.
//
// On the broker, the bench may read what any outlet says and write to any outlet; an outlet, whose
// user name is its id, may write its own hello and messages and read what is sent to it.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/child.hpp>

namespace gsbench::emulation {

struct Login {
  std::string user;
  std::string password;
};

struct Options {
  std::string folder;                // made where it is missing; nobody else may then read it
  std::vector<std::string> outlets;  // their ids: letters, digits, '-', '_', '.'
};

class PrivateBroker {
 public:
  // Returns when it accepts connections. Start it from a thread that lives as long as it should.
  static drivers::Result<PrivateBroker> start(const Options& options);

  std::uint16_t port() const { return port_; }
  std::string url() const { return "mqtts://127.0.0.1:" + std::to_string(port_); }
  const std::string& ca_file() const { return ca_file_; }
  const Login& bench() const { return bench_; }
  const Login& outlet(const std::string& id) const { return outlets_.at(id); }
  pid_t pid() const { return child_.pid(); }
  // Where it writes down what a restart is to remember.
  std::string memory_file() const { return folder_ + "/mosquitto.db"; }
  bool running() { return child_.running(); }

  void kill() noexcept { child_.kill(); }
  // On the same port, whatever became of it. After a kill, it remembers the sessions and hellos of
  // two seconds before.
  drivers::Status restart();

 private:
  explicit PrivateBroker(Child child) : child_(std::move(child)) {}

  Child child_;
  std::string folder_;
  std::uint16_t port_ = 0;
  std::string ca_file_;
  Login bench_;
  std::map<std::string, Login> outlets_;
};

}  // namespace gsbench::emulation
