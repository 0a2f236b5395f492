#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <cerrno>

#include <emulation/null_modem.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr int kMostBehind_ms = 100;

// A reader that takes nothing for kMostBehind_ms loses bytes, as on a line without flow control.
void write_all(int to, const std::vector<std::uint8_t>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put = ::send(to, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (put > 0) {
      done += static_cast<std::size_t>(put);
    } else if (errno != EINTR &&
               (errno != EAGAIN || !drivers::wait_for(to, POLLOUT, kMostBehind_ms))) {
      return;
    }
  }
}

}  // namespace

Result<std::unique_ptr<NullModem>> NullModem::create() {
  auto bench = LoopbackPort::reserve();
  auto outlet = LoopbackPort::reserve();
  if (!bench.ok() || !outlet.ok()) {
    return Error{bench.ok() ? outlet.error() : bench.error()};
  }
  std::unique_ptr<NullModem> cable(new NullModem(bench.take(), outlet.take()));
  if (const Status plugged = cable->plug_in(); !plugged.ok()) {
    return Error{plugged.error()};
  }
  return cable;
}

Status NullModem::plug_in() {
  unplug();
  for (End* const end : {&bench_, &outlet_}) {
    if (Status listening = end->port.listen(); !listening.ok()) {
      return listening;
    }
  }
  wake_ = Descriptor(eventfd(0, EFD_CLOEXEC));
  pump_ = std::thread([this] { run(); });
  return Done{};
}

void NullModem::unplug() {
  if (pump_.joinable()) {
    eventfd_write(wake_.get(), 1);
    pump_.join();
  }
  for (End* const end : {&bench_, &outlet_}) {
    end->port.refuse();
    end->connection.close();
  }
}

void NullModem::run() {
  while (true) {
    // Each end waits for bytes if connected, else for a connection.
    const auto waited_of = [](const End& end) {
      return pollfd{end.connection.is_open() ? end.connection.get() : end.port.descriptor(), POLLIN,
                    0};
    };
    pollfd waited[] = {{wake_.get(), POLLIN, 0}, waited_of(bench_), waited_of(outlet_)};
    if ((::poll(waited, 3, -1) < 0 && errno != EINTR) || waited[0].revents != 0) {
      return;
    }
    if (waited[1].revents != 0) {
      pass(bench_, outlet_, Way::kToOutlet);
    }
    if (waited[2].revents != 0) {
      pass(outlet_, bench_, Way::kToBench);
    }
  }
}

void NullModem::pass(End& from, End& to, Way way) {
  if (!from.connection.is_open()) {
    from.connection = from.port.accept();
    return;
  }
  std::vector<std::uint8_t> bytes(4096);
  const ssize_t got = ::recv(from.connection.get(), bytes.data(), bytes.size(), 0);
  if (got <= 0) {
    if (got == 0 || (errno != EAGAIN && errno != EINTR)) {
      from.connection.close();
    }
    return;
  }
  bytes.resize(static_cast<std::size_t>(got));
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const Spoiler& spoiler = spoilers_[static_cast<std::size_t>(way)]; spoiler) {
      spoiler(bytes);
    }
  }
  // The other end may have connected since poll() returned.
  if (!to.connection.is_open()) {
    to.connection = to.port.accept();
  }
  if (to.connection.is_open()) {
    write_all(to.connection.get(), bytes);
  }
}

void NullModem::spoil(Spoiler spoiler, Way way) {
  const std::lock_guard<std::mutex> lock(mutex_);
  spoilers_[static_cast<std::size_t>(way)] = std::move(spoiler);
}

}  // namespace gsbench::emulation
