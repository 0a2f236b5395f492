#include <link_framed/framed_link.hpp>
#include <poll.h>
#include <sys/eventfd.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <thread>

#include <drivers/descriptor.hpp>
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
  explicit Line(std::unique_ptr<transport::Transport> opened) : port(std::move(opened)) {}

  std::unique_ptr<transport::Transport> port;
  std::string expected_id;
  gs::wire::FrameReader reader;
  OutletStream stream{Delivery::kByCable};
  std::optional<gs::wire::Hello> hello;
  std::optional<std::size_t> outlet;  // place in what open() returned
  bool at_fault = false;              // since open(): nobody speaks with it
  bool unplugged = false;
};

}  // namespace

struct FramedLink::Impl {
  explicit Impl(FramedOptions given) : options(std::move(given)) {}

  // All of these with `mutex` held.
  Status open_ports();
  void ask();
  bool all_answered() const;
  std::vector<OutletPresence> present();
  void take(Line& line, const std::vector<std::uint8_t>& bytes, std::int64_t arrival_ns);
  bool send(Line& line, const gs::wire::Downlink& message);
  void lose(Line& line);
  void find_again(std::unique_lock<std::mutex>& lock);

  void listen();
  std::vector<pollfd> waited_for();

  FramedOptions options;
  std::mutex mutex;
  std::condition_variable hello_came;
  std::vector<std::unique_ptr<Line>> lines;
  std::vector<Received> received;
  std::vector<Line*> outlets;  // in the order that open() returned
  bool ending = false;
  drivers::Descriptor wake;  // an eventfd: there is something new to wait for
  std::thread listener;
};

Status FramedLink::Impl::open_ports() {
  for (std::size_t i = 0; i < options.ports.size(); ++i) {
    auto port = transport::make_transport(options.ports[i], options.baud);
    Status opened = port->open();
    if (opened.ok()) {
      lines.push_back(std::make_unique<Line>(std::move(port)));
      lines.back()->expected_id = i < options.ids.size() ? options.ids[i] : "";
    } else if (!options.skip_silent) {
      return opened;
    }
  }
  return Done{};
}

void FramedLink::Impl::ask() {
  for (const auto& line : lines) {
    if (!line->hello) {
      send(*line, gs::wire::identify());
    }
  }
}

bool FramedLink::Impl::all_answered() const {
  for (const auto& line : lines) {
    if (!line->hello) {
      return false;
    }
  }
  return true;
}

std::vector<OutletPresence> FramedLink::Impl::present() {
  std::vector<OutletPresence> all;
  for (const auto& line : lines) {
    const std::string& where = line->port->port();
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

void FramedLink::Impl::take(Line& line, const std::vector<std::uint8_t>& bytes,
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

void FramedLink::Impl::lose(Line& line) {
  line.port->close();
  line.unplugged = true;
  line.reader = gs::wire::FrameReader();
  line.stream.note("was unplugged from " + line.port->port());
}

bool FramedLink::Impl::send(Line& line, const gs::wire::Downlink& message) {
  return line.port->send(framed(line.stream.encode(message))).ok();
}

// Opening may block, others are sent to meanwhile.
void FramedLink::Impl::find_again(std::unique_lock<std::mutex>& lock) {
  for (const auto& line : lines) {
    if (!line->unplugged || ending) {
      continue;
    }
    auto port = transport::make_transport(line->port->port(), options.baud);
    lock.unlock();
    const bool opened = port->open().ok();
    lock.lock();
    if (opened) {
      line->port = std::move(port);
      line->unplugged = false;
      line->stream.note("is back on " + line->port->port());
      send(*line, gs::wire::identify());
    }
  }
}

std::vector<pollfd> FramedLink::Impl::waited_for() {
  std::vector<pollfd> all = {{wake.get(), POLLIN, 0}};
  for (const auto& line : lines) {
    all.push_back({line->port->descriptor(), POLLIN, 0});  // -1 is passed over
  }
  return all;
}

void FramedLink::Impl::listen() {
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
      if (ready[i + 1].revents == 0 || !line.port->is_open()) {
        continue;
      }
      bytes.clear();
      const bool there = line.port->receive(bytes, Clock::now()).ok();
      take(line, bytes, arrival_ns);
      if (!there) {
        lose(line);
      }
    }
    if (Clock::now() >= next_look) {
      find_again(lock);
      next_look = Clock::now() + kReopenEvery;
    }
  }
}

FramedLink::FramedLink(FramedOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}

FramedLink::~FramedLink() {
  close();
}

Result<std::vector<OutletPresence>> FramedLink::open() {
  close();
  std::unique_lock<std::mutex> lock(impl_->mutex);
  const Status opened = impl_->open_ports();
  if (!opened.ok()) {
    impl_->lines.clear();
    return Error{opened.error()};
  }
  impl_->ending = false;
  impl_->wake = drivers::Descriptor(eventfd(0, EFD_CLOEXEC));
  if (!impl_->wake.is_open()) {
    return Error{"framed link: no event descriptor is left"};
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

Status FramedLink::send(std::size_t outlet, const gs::wire::Downlink& message) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  if (outlet >= impl_->outlets.size()) {
    return Error{"framed link: no outlet " + std::to_string(outlet)};
  }
  Line& line = *impl_->outlets[outlet];
  if (line.at_fault) {
    return Done{};
  }
  if (!impl_->send(line, message)) {
    line.stream.note("does not take what is sent to it on " + line.port->port());
  }
  return Done{};
}

Status FramedLink::poll(std::vector<Received>& messages, std::vector<Fault>& faults) {
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

void FramedLink::close() noexcept {
  {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->ending = true;
    if (impl_->wake.is_open()) {
      eventfd_write(impl_->wake.get(), 1);
    }
  }
  if (impl_->listener.joinable()) {
    impl_->listener.join();
  }
  impl_->wake.close();
  impl_->lines.clear();
  impl_->outlets.clear();
  impl_->received.clear();
}

}  // namespace gsbench::link
