// The TCP port of an emulated generator: one client at a time, and faults of the connection.
#pragma once

#include "generator_dialect.hpp"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include <emulation/listening.hpp>

namespace gsbench::emulation {

class GeneratorServer {
 public:
  using Clock = std::chrono::steady_clock;

  // `mutex` guards the dialect and the state behind it.
  GeneratorServer(LoopbackPort port, GeneratorState& state, GeneratorDialect& dialect,
                  std::mutex& mutex);
  ~GeneratorServer() { stop(); }
  GeneratorServer(const GeneratorServer&) = delete;
  GeneratorServer& operator=(const GeneratorServer&) = delete;

  std::uint16_t port_number() const { return port_number_; }
  // Accepts connections from now on, or after `delay`.
  [[nodiscard]] drivers::Status start(std::chrono::milliseconds delay = {});
  // Closes the connection and refuses others.
  void stop();
  // The caller holds the mutex: faults count from now on.
  void faults_changed();
  // The caller holds the mutex. See Generator.
  void at_message(int message, std::function<void()> then) {
    messages_left_ = message;
    then_ = std::move(then);
  }
  std::vector<std::string>& log() { return log_; }  // the caller holds the mutex

 private:
  void run(Clock::time_point from);
  void serve();
  bool take_message(std::string_view message);
  bool answer(std::string bytes, const GeneratorFaults& faults);
  bool send(std::string_view bytes);
  // Waits; false: the server stops or the client has gone.
  bool pause_until(Clock::time_point time);
  void close_connection();

  LoopbackPort port_;
  const std::uint16_t port_number_;  // LoopbackPort::listen() writes its own in the thread
  GeneratorState& state_;
  GeneratorDialect& dialect_;
  std::mutex& mutex_;
  Descriptor connection_;
  Descriptor wake_;
  std::string received_;
  std::vector<std::string> log_;
  int messages_left_ = 0;  // until then_ is called; 0: never
  std::function<void()> then_;
  // Since the faults were set.
  int messages_ = 0;
  std::size_t bytes_ = 0;
  std::atomic<bool> dumb_ = false;  // after half an answer
  std::thread thread_;
};

}  // namespace gsbench::emulation
