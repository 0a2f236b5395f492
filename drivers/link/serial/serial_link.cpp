#include "port.hpp"
#include <libserialport.h>
#include <link_serial/serial_link.hpp>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include <link/outlet_stream.hpp>
#include <link/version_text.hpp>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kReopenEvery = std::chrono::milliseconds(250);
constexpr auto kAskEvery = std::chrono::milliseconds(500);

std::vector<std::uint8_t> framed(const std::vector<std::uint8_t>& message) {
  std::vector<std::uint8_t> bytes(gs::wire::kLongestFrame);
  bytes.resize(gs::wire::frame(message.data(), message.size(), bytes.data(), bytes.size()));
  return bytes;
}

// What is known of one port and the outlet behind it.
struct Line {
  Line(const std::string& path, int baud) : port(path, baud) {}

  Port port;
  std::string expected_id;
  gs::wire::FrameReader reader;
  OutletStream stream{Delivery::kByCable};
  std::optional<gs::wire::Hello> hello;
  std::optional<std::size_t> outlet;  // place in what open() returned
  bool at_fault = false;              // since open(): nobody speaks with it
  bool unplugged = false;
};

}  // namespace

struct SerialLink::Impl {
  explicit Impl(SerialOptions given) : options(std::move(given)) {}

  // All of these with `mutex` held.
  Status open_ports();
  void ask();
  bool all_answered() const;
  std::vector<OutletPresence> present();
  void take(Line& line, const std::vector<std::uint8_t>& bytes, std::int64_t arrival_ns);
  void lose(Line& line);
  void find_again();

  void listen();
  std::vector<pollfd> waited_for();

  SerialOptions options;
  std::mutex mutex;
  std::condition_variable hello_came;
  std::vector<std::unique_ptr<Line>> lines;
  std::vector<Received> received;
  std::vector<Line*> outlets;  // in the order that open() returned
  bool ending = false;
  int wake = -1;  // an eventfd: there is something new to wait for
  std::thread listener;
};

Status SerialLink::Impl::open_ports() {
  for (std::size_t i = 0; i < options.ports.size(); ++i) {
    auto line = std::make_unique<Line>(options.ports[i], options.baud);
    line->expected_id = i < options.ids.size() ? options.ids[i] : "";
    Status opened = line->port.open();
    if (opened.ok()) {
      lines.push_back(std::move(line));
    } else if (!options.skip_silent) {
      return opened;
    }
  }
  return Done{};
}

void SerialLink::Impl::ask() {
  for (const auto& line : lines) {
    if (!line->hello && line->port.is_open()) {
      line->port.write(framed(line->stream.encode(gs::wire::identify())));
    }
  }
}

bool SerialLink::Impl::all_answered() const {
  for (const auto& line : lines) {
    if (!line->hello) {
      return false;
    }
  }
  return true;
}

std::vector<OutletPresence> SerialLink::Impl::present() {
  std::vector<OutletPresence> all;
  for (const auto& line : lines) {
    const std::string& where = line->port.path();
    if (line->hello) {
      all.push_back({line->hello->id, where, *line->hello, protocol_fault(*line->hello)});
    } else if (!options.skip_silent) {
      const std::string& id = line->expected_id.empty() ? where : line->expected_id;
      all.push_back({id, where, {}, "does not answer"});
    } else {
      continue;
    }
    line->stream.take_faults();  // of the opening
    line->outlet = outlets.size();
    outlets.push_back(line.get());
  }
  mark_twins(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    outlets[i]->at_fault = !all[i].fault.empty();
  }
  return all;
}

void SerialLink::Impl::take(Line& line, const std::vector<std::uint8_t>& bytes,
                            std::int64_t arrival_ns) {
  for (const std::uint8_t byte : bytes) {
    const auto taken = line.reader.take(byte);
    if (taken == gs::wire::FrameReader::Taken::kBadFrame && line.hello) {
      line.stream.note("sent a damaged frame");
    }
    if (taken != gs::wire::FrameReader::Taken::kMessage) {
      continue;
    }
    const auto message = line.stream.take(line.reader.message(), line.reader.size());
    if (message && message->kind == gs::wire::UplinkKind::kHello && !line.hello) {
      line.hello = message->hello;
      hello_came.notify_all();
    } else if (message && line.outlet && !line.at_fault) {
      received.push_back({*line.outlet, *message, arrival_ns});
    }
  }
}

void SerialLink::Impl::lose(Line& line) {
  line.port.close();
  line.unplugged = true;
  line.reader = gs::wire::FrameReader();
  line.stream.note("was unplugged from " + line.port.path());
}

void SerialLink::Impl::find_again() {
  for (const auto& line : lines) {
    if (line->unplugged && line->port.open().ok()) {
      line->unplugged = false;
      line->stream.note("is back on " + line->port.path());
      line->port.write(framed(line->stream.encode(gs::wire::identify())));
    }
  }
}

std::vector<pollfd> SerialLink::Impl::waited_for() {
  std::vector<pollfd> all = {{wake, POLLIN, 0}};
  for (const auto& line : lines) {
    all.push_back({line->port.descriptor(), POLLIN, 0});  // -1 is passed over
  }
  return all;
}

void SerialLink::Impl::listen() {
  std::unique_lock<std::mutex> lock(mutex);
  Clock::time_point next_look = Clock::now();
  std::vector<std::uint8_t> bytes;
  while (!ending) {
    std::vector<pollfd> ready = waited_for();
    lock.unlock();
    ::poll(ready.data(), ready.size(), static_cast<int>(kReopenEvery.count()));
    const std::int64_t arrival_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
            .count();
    lock.lock();
    for (std::size_t i = 0; i + 1 < ready.size(); ++i) {
      Line& line = *lines[i];
      if (ready[i + 1].revents == 0 || !line.port.is_open()) {
        continue;
      }
      bytes.clear();
      const bool there = line.port.read(bytes);
      take(line, bytes, arrival_ns);
      // A hang-up with nothing left to read is the far end's death.
      if (!there || (bytes.empty() && (ready[i + 1].revents & (POLLHUP | POLLERR)) != 0)) {
        lose(line);
      }
    }
    if (Clock::now() >= next_look) {
      find_again();
      next_look = Clock::now() + kReopenEvery;
    }
  }
}

SerialLink::SerialLink(SerialOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}

SerialLink::~SerialLink() {
  close();
}

Result<std::vector<OutletPresence>> SerialLink::open() {
  close();
  std::unique_lock<std::mutex> lock(impl_->mutex);
  const Status opened = impl_->open_ports();
  if (!opened.ok()) {
    impl_->lines.clear();
    return Error{opened.error()};
  }
  impl_->ending = false;
  impl_->wake = eventfd(0, EFD_CLOEXEC);
  if (impl_->wake < 0) {
    return Error{"serial link: no event descriptor is left"};
  }
  impl_->listener = std::thread([this] { impl_->listen(); });
  const Clock::time_point end =
      Clock::now() + std::chrono::duration_cast<Clock::duration>(
                         std::chrono::duration<double>(impl_->options.answer_s));
  // Asked more than once: what an emulator or an adapter drops while it starts is gone.
  while (!impl_->all_answered() && Clock::now() < end) {
    impl_->ask();
    impl_->hello_came.wait_until(lock, std::min(end, Clock::now() + kAskEvery),
                                 [this] { return impl_->all_answered(); });
  }
  return impl_->present();
}

Status SerialLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  if (outlet >= impl_->outlets.size()) {
    return Error{"serial link: no outlet " + std::to_string(outlet)};
  }
  Line& line = *impl_->outlets[outlet];
  if (line.at_fault) {
    return Done{};
  }
  const std::vector<std::uint8_t> bytes = framed(line.stream.encode(message));
  if (!line.port.is_open() || !line.port.write(bytes)) {
    line.stream.note("does not take what is sent to it on " + line.port.path());
  }
  return Done{};
}

Status SerialLink::poll(std::vector<Received>& messages, std::vector<Fault>& faults) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  messages.insert(messages.end(), impl_->received.begin(), impl_->received.end());
  impl_->received.clear();
  for (std::size_t i = 0; i < impl_->outlets.size(); ++i) {
    Line& line = *impl_->outlets[i];
    for (std::string& fault : line.stream.take_faults()) {
      if (!line.at_fault) {
        faults.push_back({i, std::move(fault)});
      }
    }
  }
  return Done{};
}

void SerialLink::close() noexcept {
  {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->ending = true;
    const std::uint64_t one = 1;
    if (impl_->wake >= 0 && ::write(impl_->wake, &one, sizeof one) != sizeof one) {
      // The listener looks a few times a second by itself.
    }
  }
  if (impl_->listener.joinable()) {
    impl_->listener.join();
  }
  if (impl_->wake >= 0) {
    ::close(impl_->wake);
    impl_->wake = -1;
  }
  impl_->lines.clear();
  impl_->outlets.clear();
  impl_->received.clear();
}

std::vector<std::string> serial_ports() {
  std::vector<std::string> paths;
  sp_port** ports = nullptr;
  if (sp_list_ports(&ports) != SP_OK) {
    return paths;
  }
  for (std::size_t i = 0; ports[i] != nullptr; ++i) {
    paths.emplace_back(sp_get_port_name(ports[i]));
  }
  sp_free_port_list(ports);
  return paths;
}

}  // namespace gsbench::link
