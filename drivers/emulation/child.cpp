#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include <emulation/child.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;

namespace {

// Runs in the child, between fork and exec: async-signal-safe calls only. Writes errno to `report`
// if a call fails.
[[noreturn]] void become(char* const* argv, const char* output, pid_t parent, int report) {
  const auto fail = [&] {
    const int error = errno;
    if (write(report, &error, sizeof error) != sizeof error) {
      _exit(126);
    }
    _exit(127);
  };
  if (prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || getppid() != parent) {
    fail();
  }
  // An own process group: Ctrl-C at the terminal reaches the bench only, which ends the run safely.
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int in = open("/dev/null", O_RDONLY);
  const int out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  if (in < 0 || out < 0 || dup2(in, STDIN_FILENO) < 0 || dup2(out, STDOUT_FILENO) < 0 ||
      dup2(out, STDERR_FILENO) < 0) {
    fail();
  }
  execvp(argv[0], argv);
  fail();
  _exit(127);
}

}  // namespace

Result<Child> Child::start(const Command& command) {
  std::vector<std::string> words = command.words;
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  const std::string output = command.output.empty() ? "/dev/null" : command.output;
  int report[2];
  if (pipe2(report, O_CLOEXEC) != 0) {
    return Error{words.front() + ": " + std::strerror(errno)};
  }
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    become(argv.data(), output.c_str(), parent, report[1]);
  }
  int error = pid < 0 ? errno : 0;
  close(report[1]);
  if (pid > 0 && read(report[0], &error, sizeof error) <= 0) {
    error = 0;  // exec succeeded and closed the pipe
  }
  close(report[0]);
  if (error != 0) {
    if (pid > 0) {
      waitpid(pid, nullptr, 0);
    }
    return Error{words.front() + ": cannot be started: " + std::strerror(error)};
  }
  return Child(pid);
}

bool Child::running() {
  return pid_ > 0 && !wait_for_end(0);
}

void Child::stop() noexcept {
  if (pid_ <= 0) {
    return;
  }
  ::kill(pid_, SIGTERM);
  if (!wait_for_end(1000)) {
    kill();
  }
}

void Child::kill() noexcept {
  if (pid_ <= 0) {
    return;
  }
  ::kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  pid_ = -1;
}

bool Child::wait_for_end(int milliseconds) noexcept {
  const auto until = std::chrono::steady_clock::now() + std::chrono::milliseconds(milliseconds);
  while (true) {
    const pid_t ended = waitpid(pid_, nullptr, WNOHANG);
    if (ended == pid_ || (ended < 0 && errno == ECHILD)) {
      pid_ = -1;
      return true;
    }
    if (std::chrono::steady_clock::now() >= until) {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
}

}  // namespace gsbench::emulation
