// Signals, and the output of a physical source while a command uses it.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>

#include <station/station_file.hpp>

namespace gsbench::cli {

// Handles SIGINT, SIGTERM, SIGQUIT and SIGHUP. The returned flag is set when one of them arrives,
// so that a run ends in its safe state. The second of SIGINT, SIGTERM and SIGQUIT ends the process.
// SIGHUP never does, because a terminal that is gone may send it twice. A SIGHUP that the parent
// ignores, as nohup does, stays ignored.
const std::atomic<bool>& catch_interrupts();

// While it exists, the source of a station may have its output on. Does nothing for a station whose
// source ends with the bench. One at a time.
//
// - A signal that ends the process says first that the state of the output is unknown.
// - SIGPIPE is ignored: a reader that is gone fails the write, and does not end the bench.
class LiveOutput {
 public:
  // kEnd: the first of SIGINT, SIGTERM and SIGQUIT ends the process at once, with kInterrupted.
  enum class FirstSignal : std::uint8_t { kNote, kEnd };

  // `station`: as the user named it.
  LiveOutput(const station::StationFile& file, const std::string& station,
             FirstSignal first = FirstSignal::kNote);
  ~LiveOutput();
  LiveOutput(const LiveOutput&) = delete;
  LiveOutput& operator=(const LiveOutput&) = delete;

 private:
  std::string if_killed_;
  void (*before_)(int) = nullptr;  // the handler of SIGPIPE
};

// The state of a source's output once a command is done with it.
class OutputState {
 public:
  // Prints at once why it is unknown and what to do, before anything else can fail.
  void note_unknown(const std::string& what);
  // The exit code of `rest`, which is called once; kErrored if the state is unknown, also if `rest`
  // throws. Then its error is printed.
  int exit_code_of(const std::function<int()>& rest) const;

 private:
  bool unknown_ = false;
};

}  // namespace gsbench::cli
