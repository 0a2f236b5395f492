#include "descriptor.hpp"
#include <fcntl.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

#include <emulation/null_modem.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;

namespace {

// The master of a pseudo-terminal whose slave is raw. The slave is kept open here too: a terminal
// that nobody has open loses what is written to it, and reads as unplugged.
struct Terminal {
  Descriptor master;
  Descriptor slave;
  std::string path;
};

Result<Terminal> new_terminal() {
  Terminal terminal;
  terminal.master = Descriptor(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK));
  char path[64] = {};
  if (!terminal.master.is_open() || grantpt(terminal.master.get()) != 0 ||
      unlockpt(terminal.master.get()) != 0 ||
      ptsname_r(terminal.master.get(), path, sizeof path) != 0) {
    return Error{std::string("no pseudo-terminal: ") + std::strerror(errno)};
  }
  terminal.path = path;
  terminal.slave = Descriptor(::open(path, O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  if (!terminal.slave.is_open() || tcgetattr(terminal.slave.get(), &settings) != 0) {
    return Error{terminal.path + ": " + std::strerror(errno)};
  }
  cfmakeraw(&settings);
  tcsetattr(terminal.slave.get(), TCSANOW, &settings);
  return terminal;
}

}  // namespace

struct NullModem::Impl {
  ~Impl() {
    const std::uint64_t one = 1;
    if (wake.is_open() && ::write(wake.get(), &one, sizeof one) == sizeof one && pump.joinable()) {
      pump.join();
    }
  }

  void run();
  void accept_outlet();
  bool pass(int from, int to, Way way);
  int outlet_descriptor() const {
    return listening.is_open() ? connection.get() : outlet.master.get();
  }

  Terminal bench;
  Terminal outlet;       // of two terminals
  Descriptor listening;  // of a socket
  Descriptor connection;
  std::string socket_path;
  Descriptor wake;
  std::mutex mutex;
  std::array<Spoiler, 2> spoilers;  // by the way
  std::thread pump;
};

void NullModem::Impl::run() {
  // An end that has gone is an error to tell, not the end of the program.
  sigset_t broken_pipe;
  sigemptyset(&broken_pipe);
  sigaddset(&broken_pipe, SIGPIPE);
  pthread_sigmask(SIG_BLOCK, &broken_pipe, nullptr);
  while (true) {
    pollfd waited[] = {{wake.get(), POLLIN, 0},
                       {bench.master.get(), POLLIN, 0},
                       {outlet_descriptor(), POLLIN, 0},
                       {connection.is_open() ? -1 : listening.get(), POLLIN, 0}};
    if (::poll(waited, 4, -1) < 0 && errno != EINTR) {
      return;
    }
    if (waited[0].revents != 0) {
      return;
    }
    if (waited[3].revents != 0) {
      accept_outlet();
    }
    if (waited[1].revents != 0 && outlet_descriptor() >= 0) {
      pass(bench.master.get(), outlet_descriptor(), Way::kToOutlet);
    } else if (waited[1].revents != 0) {
      // Nobody at the other end: lost, as on a cable.
      pass(bench.master.get(), -1, Way::kToOutlet);
    }
    if (waited[2].revents != 0 && !pass(outlet_descriptor(), bench.master.get(), Way::kToBench)) {
      connection.close();
    }
  }
}

void NullModem::Impl::accept_outlet() {
  connection = Descriptor(accept4(listening.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
}

// False where `from` has hung up.
bool NullModem::Impl::pass(int from, int to, Way way) {
  std::vector<std::uint8_t> bytes(4096);
  const ssize_t got = ::read(from, bytes.data(), bytes.size());
  if (got <= 0) {
    return got < 0 && (errno == EAGAIN || errno == EINTR);
  }
  bytes.resize(static_cast<std::size_t>(got));
  {
    const std::lock_guard<std::mutex> lock(mutex);
    if (const Spoiler& spoiler = spoilers[static_cast<std::size_t>(way)]; spoiler) {
      spoiler(bytes);
    }
  }
  std::size_t done = 0;
  while (to >= 0 && done < bytes.size()) {
    const ssize_t put = ::write(to, bytes.data() + done, bytes.size() - done);
    if (put > 0) {
      done += static_cast<std::size_t>(put);
      continue;
    }
    // A reader that is behind for so long loses bytes, as on a line without flow control.
    pollfd room{to, POLLOUT, 0};
    if (errno != EAGAIN || ::poll(&room, 1, 100) <= 0) {
      break;
    }
  }
  return true;
}

NullModem::NullModem(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {
  impl_->wake = Descriptor(eventfd(0, EFD_CLOEXEC));
  impl_->pump = std::thread([raw = impl_.get()] { raw->run(); });
}

NullModem::NullModem(NullModem&&) noexcept = default;
NullModem& NullModem::operator=(NullModem&&) noexcept = default;
NullModem::~NullModem() = default;

Result<NullModem> NullModem::between_terminals() {
  auto impl = std::make_unique<Impl>();
  Result<Terminal> bench = new_terminal();
  Result<Terminal> outlet = new_terminal();
  if (!bench.ok() || !outlet.ok()) {
    return Error{bench.ok() ? outlet.error() : bench.error()};
  }
  impl->bench = bench.take();
  impl->outlet = outlet.take();
  return NullModem(std::move(impl));
}

Result<NullModem> NullModem::to_socket(const std::string& socket_path) {
  auto impl = std::make_unique<Impl>();
  Result<Terminal> bench = new_terminal();
  if (!bench.ok()) {
    return Error{bench.error()};
  }
  impl->bench = bench.take();
  Result<Descriptor> listening = listen_on(socket_path);
  if (!listening.ok()) {
    return Error{listening.error()};
  }
  impl->listening = listening.take();
  impl->socket_path = socket_path;
  return NullModem(std::move(impl));
}

const std::string& NullModem::bench_end() const {
  return impl_->bench.path;
}

const std::string& NullModem::outlet_end() const {
  return impl_->socket_path.empty() ? impl_->outlet.path : impl_->socket_path;
}

void NullModem::spoil(Spoiler spoiler, Way way) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  impl_->spoilers[static_cast<std::size_t>(way)] = std::move(spoiler);
}

}  // namespace gsbench::emulation
