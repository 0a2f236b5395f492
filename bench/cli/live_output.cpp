#include "live_output.hpp"

#include "commands.hpp"
#include <unistd.h>

#include <csignal>
#include <exception>

#include <fmt/format.h>

namespace gsbench::cli {
namespace {

std::atomic<bool> interrupt_arrived{false};
std::atomic<bool> asked_to_end{false};
std::atomic<bool> first_ends{false};
std::atomic<const std::string*> said_if_killed{nullptr};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");
static_assert(std::atomic<const std::string*>::is_always_lock_free, "read in a signal handler");

void note_hangup(int) {
  interrupt_arrived = true;
}

void note_interrupt(int signal) {
  interrupt_arrived = true;
  if (!asked_to_end.exchange(true) && !first_ends) {
    return;
  }
  if (const std::string* const text = said_if_killed) {
    (void)!::write(STDERR_FILENO, text->data(), text->size());
  }
  if (first_ends) {
    ::_exit(kInterrupted);
  }
  // Blocked until this handler returns.
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

}  // namespace

const std::atomic<bool>& catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM, SIGQUIT}) {
    std::signal(signal, note_interrupt);
  }
  if (std::signal(SIGHUP, note_hangup) == SIG_IGN) {
    std::signal(SIGHUP, SIG_IGN);
  }
  return interrupt_arrived;
}

LiveOutput::LiveOutput(const station::StationFile& file, const std::string& station,
                       FirstSignal first) {
  if (!file.make_source) {
    return;
  }
  if_killed_ = '\n' + error_line(fmt::format(
                          "{}: ended before the output was known to be off: output state unknown. "
                          "The outlets may be live: run `gsbench safe {}`, or switch the source "
                          "off by hand, or unplug it.",
                          file.source_port, station));
  said_if_killed = &if_killed_;
  first_ends = first == FirstSignal::kEnd;
  before_ = std::signal(SIGPIPE, SIG_IGN);
}

LiveOutput::~LiveOutput() {
  if (!if_killed_.empty()) {
    first_ends = false;
    said_if_killed = nullptr;
    std::signal(SIGPIPE, before_);
  }
}

void OutputState::note_unknown(const std::string& what) {
  unknown_ = true;
  print_error(what);
}

int OutputState::exit_code_of(const std::function<int()>& rest) const {
  try {
    const int exit_code = rest();
    return unknown_ ? kErrored : exit_code;
  } catch (const std::exception& error) {
    if (!unknown_) {
      throw;
    }
    print_error(error.what());
    return kErrored;
  }
}

}  // namespace gsbench::cli
