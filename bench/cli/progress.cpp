#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

#include <fmt/format.h>

#include <render/layout.hpp>

namespace gsbench::cli {

using std::chrono::duration;
using std::chrono::steady_clock;

namespace {

// On a pipe, which keeps all lines.
constexpr double kFirstLine_s = 2.0;
constexpr double kNextLine_s = 10.0;

}  // namespace

Progress::Progress(const std::string& what)
    : what_(render::shortened(what, 60)),
      terminal_(isatty(STDERR_FILENO) == 1),
      started_(steady_clock::now()),
      last_(started_) {}

Progress::~Progress() {
  clear();
}

void Progress::clear() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
    drawn_ = false;
  }
}

void Progress::show(double part) {
  const auto now = steady_clock::now();
  const double elapsed_s = duration<double>(now - started_).count();
  if (!terminal_ || !(part > 0.0) || elapsed_s < 0.5 ||
      duration<double>(now - last_).count() < 0.1) {
    return;
  }
  const double left_s = elapsed_s * (1.0 - part) / part;
  if (!drawn_ && elapsed_s + left_s < 2.0) {
    return;
  }
  print(fmt::format("{}: {:3.0f} %, {:.0f} s left", what_, 100.0 * part, left_s));
}

void Progress::show(const std::string& what) {
  const auto now = steady_clock::now();
  if (!terminal_) {
    if (duration<double>(now - last_).count() >= (lines_ == 0 ? kFirstLine_s : kNextLine_s)) {
      last_ = now;
      ++lines_;
      std::fputs((what_ + ": " + what + '\n').c_str(), stderr);
    }
    return;
  }
  if (duration<double>(now - started_).count() >= 0.5 &&
      duration<double>(now - last_).count() >= 0.1) {
    print(what_ + ": " + what);
  }
}

void Progress::print(const std::string& line) {
  last_ = steady_clock::now();
  drawn_ = true;
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
}

}  // namespace gsbench::cli
