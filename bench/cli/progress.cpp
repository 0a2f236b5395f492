#include "progress.hpp"

#include <unistd.h>

#include <cstdio>

#include <render/layout.hpp>

namespace gsbench::cli {

using std::chrono::duration;
using std::chrono::steady_clock;

Progress::Progress(const std::string& what)
    : what_(render::shortened(what, 60)),
      terminal_(isatty(STDERR_FILENO) == 1),
      started_(steady_clock::now()),
      last_(started_) {}

Progress::~Progress() {
  if (drawn_) {
    std::fputs("\r\033[K", stderr);
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
  last_ = now;
  drawn_ = true;
  std::fprintf(stderr, "\r\033[K%s: %3.0f %%, %.0f s left", what_.c_str(), 100.0 * part, left_s);
  std::fflush(stderr);
}

}  // namespace gsbench::cli
