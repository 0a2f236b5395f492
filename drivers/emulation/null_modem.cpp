#include "listening.hpp"
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>

#include <array>
#include <cerrno>
#include <mutex>
#include <thread>

#include <emulation/null_modem.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

struct End {
  explicit End(LoopbackPort reserved) : port(std::move(reserved)) {}

  LoopbackPort port;
  Descriptor connection;
};

constexpr int kMostBehindMs = 100;

// A reader that is behind for so long loses bytes, as on a line without flow control.
void write_all(int to, const std::vector<std::uint8_t>& bytes) {
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t put = ::send(to, bytes.data() + done, bytes.size() - done, MSG_NOSIGNAL);
    if (put > 0) {
      done += static_cast<std::size_t>(put);
    } else if (errno != EINTR &&
               (errno != EAGAIN || !drivers::wait_for(to, POLLOUT, kMostBehindMs))) {
      return;
    }
  }
}

}  // namespace

struct NullModem::Impl {
  Impl(LoopbackPort for_bench, LoopbackPort for_outlet)
      : bench(std::move(for_bench)), outlet(std::move(for_outlet)) {}
  ~Impl() { unplug(); }

  Status plug_in();
  void unplug();
  void run();
  void pass(End& from, End& to, Way way);

  End bench;
  End outlet;
  Descriptor wake;
  std::mutex mutex;
  std::array<Spoiler, 2> spoilers;  // by the way
  std::thread pump;
};

Status NullModem::Impl::plug_in() {
  unplug();
  for (End* const end : {&bench, &outlet}) {
    Status listening = end->port.listen();
    if (!listening.ok()) {
      return listening;
    }
  }
  wake = Descriptor(eventfd(0, EFD_CLOEXEC));
  pump = std::thread([this] { run(); });
  return Done{};
}

void NullModem::Impl::unplug() {
  if (pump.joinable()) {
    eventfd_write(wake.get(), 1);
    pump.join();
  }
  for (End* const end : {&bench, &outlet}) {
    end->port.refuse();
    end->connection.close();
  }
}

void NullModem::Impl::run() {
  while (true) {
    // Each end: the bytes that came, or who connects.
    const auto waited_of = [](const End& end) {
      return pollfd{end.connection.is_open() ? end.connection.get() : end.port.descriptor(), POLLIN,
                    0};
    };
    pollfd waited[] = {{wake.get(), POLLIN, 0}, waited_of(bench), waited_of(outlet)};
    if ((::poll(waited, 3, -1) < 0 && errno != EINTR) || waited[0].revents != 0) {
      return;
    }
    if (waited[1].revents != 0) {
      pass(bench, outlet, Way::kToOutlet);
    }
    if (waited[2].revents != 0) {
      pass(outlet, bench, Way::kToBench);
    }
  }
}

void NullModem::Impl::pass(End& from, End& to, Way way) {
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
    const std::lock_guard<std::mutex> lock(mutex);
    if (const Spoiler& spoiler = spoilers[static_cast<std::size_t>(way)]; spoiler) {
      spoiler(bytes);
    }
  }
  // Whoever has connected is there, also where poll() has not said so yet.
  if (!to.connection.is_open()) {
    to.connection = to.port.accept();
  }
  if (to.connection.is_open()) {
    write_all(to.connection.get(), bytes);
  }
}

NullModem::NullModem(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
NullModem::NullModem(NullModem&&) noexcept = default;
NullModem& NullModem::operator=(NullModem&&) noexcept = default;
NullModem::~NullModem() = default;

Result<NullModem> NullModem::create() {
  auto bench = LoopbackPort::reserve();
  auto outlet = LoopbackPort::reserve();
  if (!bench.ok() || !outlet.ok()) {
    return Error{bench.ok() ? outlet.error() : bench.error()};
  }
  NullModem cable(std::make_unique<Impl>(bench.take(), outlet.take()));
  const Status plugged = cable.plug_in();
  if (!plugged.ok()) {
    return Error{plugged.error()};
  }
  return cable;
}

std::string NullModem::bench_end() const {
  return "tcp://127.0.0.1:" + std::to_string(impl_->bench.port.number());
}

std::uint16_t NullModem::outlet_end() const {
  return impl_->outlet.port.number();
}

void NullModem::unplug() {
  impl_->unplug();
}

Status NullModem::plug_in() {
  return impl_->plug_in();
}

void NullModem::spoil(Spoiler spoiler, Way way) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  impl_->spoilers[static_cast<std::size_t>(way)] = std::move(spoiler);
}

}  // namespace gsbench::emulation
