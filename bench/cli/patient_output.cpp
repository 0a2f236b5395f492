#include "patient_output.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <utility>

namespace gsbench::cli {
namespace {

// A second opening of a pipe or terminal: O_NONBLOCK on the first would apply to all processes that
// share it, such as the shell. Not open: the descriptor is something else, or may not be opened.
drivers::Descriptor opened_without_blocking(int descriptor) {
  struct stat state {};
  if (::fstat(descriptor, &state) != 0 || !(S_ISFIFO(state.st_mode) || S_ISCHR(state.st_mode))) {
    return drivers::Descriptor();
  }
  const std::string path = "/proc/self/fd/" + std::to_string(descriptor);
  return drivers::Descriptor(::open(path.c_str(), O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC));
}

}  // namespace

PatientOutput::PatientOutput(int descriptor, std::function<std::string(std::uint64_t)> notice)
    : descriptor_(descriptor),
      own_(opened_without_blocking(descriptor)),
      is_terminal_(::isatty(descriptor) == 1),
      notice_(std::move(notice)) {
  std::signal(SIGPIPE, SIG_IGN);
}

void PatientOutput::put(const std::string& line) {
  if (left_out_ > 0 || waiting_bytes() + line.size() >= kRoom_bytes) {
    ++left_out_;
    return;
  }
  waiting_ += line;
  waiting_ += '\n';
}

bool PatientOutput::takes_some(std::chrono::milliseconds patience) const {
  pollfd ready{target(), POLLOUT, 0};
  return ::poll(&ready, 1, static_cast<int>(patience.count())) > 0;
}

void PatientOutput::flush() {
  // A pipe or socket that is ready takes this much without blocking.
  constexpr std::size_t kAtOnce_bytes = PIPE_BUF;
  while (waiting_bytes() > 0 && error_ == 0 && takes_some(std::chrono::milliseconds(0))) {
    const ssize_t taken =
        ::write(target(), waiting_.data() + written_, std::min(waiting_bytes(), kAtOnce_bytes));
    if (taken >= 0) {
      written_ += static_cast<std::size_t>(taken);
    } else if (errno == EAGAIN) {
      break;
    } else if (errno != EINTR) {
      error_ = errno;
    }
  }
  if (written_ > kRoom_bytes / 2 || waiting_bytes() == 0) {
    waiting_.erase(0, written_);
    written_ = 0;
  }
  if (left_out_ > 0 && waiting_bytes() <= kRoom_bytes / 2) {
    const std::uint64_t count = std::exchange(left_out_, 0);
    put(notice_(count));
  }
}

void PatientOutput::finish(std::chrono::milliseconds patience) {
  flush();
  while (waiting_bytes() > 0 && error_ == 0 && takes_some(patience)) {
    flush();
  }
}

}  // namespace gsbench::cli
