// A USB serial adapter between the bench and an emulated instrument: a pseudo-terminal whose bytes
// are those of the instrument's TCP connection. A closed connection is a replugged adapter: its
// port hangs up, and is there again as soon as the instrument accepts a connection. Unlike TCP, the
// line does not report to the instrument that the bench has closed the port.
#pragma once

#include <pty.hpp>
#include <test_support/temporary_folder.hpp>

#include <atomic>
#include <memory>
#include <string>
#include <thread>

#include <transport/transport.hpp>

namespace gsbench::test {

class SerialAdapter {
 public:
  // `instrument`: for transport::make_transport(). Blocks until the port is there.
  explicit SerialAdapter(const std::string& instrument);
  ~SerialAdapter();
  SerialAdapter(const SerialAdapter&) = delete;
  SerialAdapter& operator=(const SerialAdapter&) = delete;

  std::string port() const { return folder_.file("ttyUSB0"); }
  // Blocks until the port is there, or not there. Throws std::runtime_error after 1 min.
  void wait_for_port(bool there) const;
  // Blocks until the adapter has been plugged in more than `times` times since it was made.
  void wait_for_more_plugs_than(int times) const;
  int plugs() const { return plugs_; }

 private:
  void run();
  void plug();
  void pass_bytes();

  TemporaryFolder folder_;
  std::unique_ptr<transport::Transport> instrument_;
  std::unique_ptr<Pty> pty_;
  std::atomic<int> plugs_{0};
  std::atomic<bool> is_there_{false};
  std::atomic<bool> ending_{false};
  std::thread thread_;  // last: it uses the others
};

}  // namespace gsbench::test
