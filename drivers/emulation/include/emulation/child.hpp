// A program that runs beside the bench for as long as the bench wants it: an emulator, a broker. It
// ends with its owner, also where the bench itself is killed.
#pragma once

#include <sys/types.h>

#include <string>
#include <utility>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::emulation {

struct Command {
  std::vector<std::string> words;  // the program, looked for in PATH, and its arguments
  std::string output;              // file for its standard output and error; empty: nowhere
};

class Child {
 public:
  // Linux kills a child when the thread that started it ends: start children from a thread that
  // lives as long as they should.
  static drivers::Result<Child> start(const Command& command);

  Child(Child&& other) noexcept : pid_(std::exchange(other.pid_, -1)) {}
  // What it was before is stopped.
  Child& operator=(Child other) noexcept {
    std::swap(pid_, other.pid_);
    return *this;
  }
  ~Child() { stop(); }

  pid_t pid() const { return pid_; }
  bool running();
  // SIGTERM, and SIGKILL where that has not helped within a second; waits for the end.
  void stop() noexcept;
  // SIGKILL at once.
  void kill() noexcept;

 private:
  explicit Child(pid_t pid) : pid_(pid) {}
  bool wait_for_end(int milliseconds) noexcept;

  pid_t pid_ = -1;  // -1: none, or it has ended
};

}  // namespace gsbench::emulation
