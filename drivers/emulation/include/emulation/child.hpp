// A child process of the bench: an emulator or a broker. The process ends when its Child is
// destroyed, and also if the bench is killed.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::emulation {

struct Command {
  std::vector<std::string> words;  // the program, searched for in PATH, and its arguments
  std::string output;              // file for its standard output and error; empty: discarded
};

class Child {
 public:
  // Linux kills the child when the thread that called start() ends, so that thread must outlive the
  // child. Returns an error if the program cannot be started.
  static drivers::Result<Child> start(const Command& command);

  Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}
  // Stops the process held so far.
  Child& operator=(Child other) noexcept {
    std::swap(pid_, other.pid_);
    return *this;
  }
  ~Child() { stop(); }

  pid_t pid() const { return pid_; }
  bool running();
  // Sends SIGTERM, then SIGKILL if the process has not ended within 1 s. Blocks until it has ended.
  void stop() noexcept;
  // Sends SIGKILL at once. Blocks until the process has ended.
  void kill() noexcept;

 private:
  explicit Child(pid_t pid) : pid_(pid) {}
  bool wait_for_end(int milliseconds) noexcept;

  pid_t pid_ = -1;  // -1: none, or it has ended
};

}  // namespace gsbench::emulation
