// A Mosquitto process of the bench on 127.0.0.1, with TLS, passwords and an access list. It ends
// with its owner.
//
// The bench may read the messages of all outlets and write to all outlets. An outlet's user name is
// its id; it may write its own hello and messages, and read the messages sent to it.
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
  std::string folder;                // created if missing; made readable for its owner only
  std::vector<std::string> outlets;  // their ids: letters, digits, '-', '_', '.'
};

class PrivateBroker {
 public:
  // Blocks until the broker accepts connections. Returns an error if it does not within 10 s. Call
  // start() from a thread that outlives the broker (emulation/child.hpp).
  static drivers::Result<PrivateBroker> start(const Options& options);

  std::uint16_t port() const { return port_; }
  std::string url() const { return "mqtts://127.0.0.1:" + std::to_string(port_); }
  const std::string& ca_file() const { return ca_file_; }
  const Login& bench() const { return bench_; }
  const Login& outlet(const std::string& id) const { return outlets_.at(id); }
  pid_t pid() const { return child_.pid(); }
  // The broker's persistence file.
  std::string memory_file() const { return folder_ + "/mosquitto.db"; }
  bool running() { return child_.running(); }

  void kill() noexcept { child_.kill(); }
  // Starts the broker again on the same port; stops it first if it still runs. After a kill, the
  // sessions and hellos of the last two seconds may be missing.
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
