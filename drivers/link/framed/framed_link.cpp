#include <link_framed/framed_link.hpp>
#include <poll.h>
#include <sys/eventfd.h>

#include <chrono>
#include <condition_variable>
#include <cstring>
#include <mutex>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include <drivers/descriptor.hpp>
#include <link/outlet_stream.hpp>
#include <link/version_text.hpp>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;
using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kReopenEvery = std::chrono::milliseconds(250);
constexpr auto kAskEvery = std::chrono::milliseconds(500);

bool same_id(const gs::wire::Hello& one, const gs::wire::Hello& other) {
  return std::strcmp(one.id, other.id) == 0;
}

std::vector<std::uint8_t> framed(const std::vector<std::uint8_t>& message) {
  std::vector<std::uint8_t> bytes(gs::wire::kLongestFrame);
  bytes.resize(gs::wire::frame(message.data(), message.size(), bytes.data(), bytes.size()));
  return bytes;
}

// The state of one port and the outlet behind it.
struct Line {
  explicit Line(std::unique_ptr<transport::Transport> opened) : port(std::move(opened)) {}

  std::unique_ptr<transport::Transport> port;
  gs::wire::FrameReader reader;
  OutletStream stream{Delivery::kByCable};
  std::optional<gs::wire::Hello> hello;  // of the outlet that joined on it
  Clock::time_point next_identify;       // if its outlet has not answered by then
  std::string cannot_open;               // why; empty: it is open, or was
  bool unplugged = false;
  bool left = false;
  bool joins_again = false;  // with its next hello
  bool faulty = false;       // excluded from the run
  bool is_twin = false;      // which is why it is excluded
};

}  // namespace

struct FramedLink::Impl {
  explicit Impl(FramedOptions given) : options(std::move(given)) {}

  // Call these with `mutex` held.
  void open_ports();
  void ask();
  void identify(Line& line);
  void take(Line& line, const std::vector<std::uint8_t>& bytes, std::int64_t arrival_ns);
  void take(Line& line, const gs::wire::Uplink& message, std::int64_t arrival_ns);
  void join(Line& line, const gs::wire::Uplink& message, std::int64_t arrival_ns);
  void mark_twins(Line& line);
  void leave(Line& line, const std::string& how);
  void end_twins(const std::string& id);
  Line* find(const std::string& id);
  bool send(Line& line, const gs::wire::Downlink& message);
  void lose(Line& line);
  void reopen_ports(std::unique_lock<std::mutex>& lock);

  void listen();
  void reopen();

  FramedOptions options;
  std::mutex mutex;
  std::vector<std::unique_ptr<Line>> lines;
  std::set<std::string> known;  // ids of all outlets that have ever joined
  Happenings happenings;        // without most faults: the streams keep those
  bool ending = false;
  drivers::Descriptor wake;  // an eventfd that ends the listener's wait
  std::condition_variable ended;
  std::thread listener;
  std::thread opener;
};

void FramedLink::Impl::open_ports() {
  for (const std::string& name : options.ports) {
    Line& line =
        *lines.emplace_back(std::make_unique<Line>(transport::make_transport(name, options.baud)));
    if (const Status opened = line.port->open(); !opened.ok()) {
      line.cannot_open = opened.error();
      line.unplugged = true;
    }
  }
}

// Called repeatedly: an emulator or an adapter may drop bytes while it starts.
void FramedLink::Impl::ask() {
  for (const auto& line : lines) {
    const bool answered =
        line->hello && !line->joins_again && (line->faulty || line->stream.is_open());
    if (!answered && !line->unplugged && Clock::now() >= line->next_identify) {
      identify(*line);
    }
  }
}

void FramedLink::Impl::identify(Line& line) {
  send(line, gs::wire::identify());
  line.next_identify = Clock::now() + kAskEvery;
}

Line* FramedLink::Impl::find(const std::string& id) {
  for (const auto& line : lines) {
    if (line->hello && line->hello->id == id) {
      return line.get();
    }
  }
  return nullptr;
}

void FramedLink::Impl::join(Line& line, const gs::wire::Uplink& message, std::int64_t arrival_ns) {
  const gs::wire::Hello& hello = message.hello;
  if (!line.hello) {
    line.stream.take_faults();  // drops faults from before the outlet was known
  }
  const std::string fault = protocol_fault(hello);
  line.faulty = !fault.empty();
  line.left = line.joins_again = line.is_twin = false;
  line.hello = hello;
  mark_twins(line);
  known.insert(hello.id);
  happenings.changes.emplace_back(OutletPresence{hello.id, line.port->port(), hello, fault,
                                                 message.start_number, message.sample, arrival_ns});
}

void FramedLink::Impl::mark_twins(Line& line) {
  for (const auto& other : lines) {
    if (other.get() == &line || !other->hello || !same_id(*other->hello, *line.hello)) {
      continue;
    }
    if (other->left) {
      other->hello.reset();  // the outlet was plugged into another port
    } else {
      line.faulty = line.is_twin = other->faulty = other->is_twin = true;
    }
  }
}

void FramedLink::Impl::leave(Line& line, const std::string& how) {
  if (line.hello && !line.left) {
    happenings.changes.emplace_back(Fault{line.hello->id, how, line.port->port()});
  }
  line.left = line.joins_again = true;
  if (std::exchange(line.is_twin, false)) {
    end_twins(line.hello->id);
  }
}

// Of two, one has left: the other is asked for its hello, and joins again.
void FramedLink::Impl::end_twins(const std::string& id) {
  std::vector<Line*> twins;
  for (const auto& line : lines) {
    if (line->is_twin && line->hello->id == id) {
      twins.push_back(line.get());
    }
  }
  if (twins.size() == 1) {
    twins[0]->is_twin = false;
    twins[0]->joins_again = true;
  }
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
    if (const auto message = line.stream.take(line.reader.message(), line.reader.size())) {
      take(line, *message, arrival_ns);
    }
    if (line.stream.take_wants_identify() && !line.faulty) {
      identify(line);
    }
  }
}

void FramedLink::Impl::take(Line& line, const gs::wire::Uplink& message, std::int64_t arrival_ns) {
  const bool is_hello = message.kind == gs::wire::UplinkKind::kHello;
  if (is_hello && line.hello && !same_id(*line.hello, message.hello)) {
    leave(line, "is no longer on " + line.port->port() + ": outlet " + message.hello.id +
                    " is there now");
  }
  // With another version of the protocol: other firmware.
  const bool is_updated = is_hello && line.hello && !line.is_twin &&
                          message.hello.protocol_version != line.hello->protocol_version;
  if (is_hello && (!line.hello || line.joins_again || is_updated)) {
    join(line, message, arrival_ns);
  } else if (line.hello && !line.faulty) {
    happenings.messages.push_back({line.hello->id, message, arrival_ns, line.stream.sequence()});
  }
}

void FramedLink::Impl::lose(Line& line) {
  line.port->close();
  line.unplugged = true;
  line.reader = gs::wire::FrameReader();
  leave(line, "was unplugged from " + line.port->port());
}

bool FramedLink::Impl::send(Line& line, const gs::wire::Downlink& message) {
  return line.port->send(framed(line.stream.encode(message))).ok();
}

// Opening may block: it runs without the lock, so that the other outlets are not affected.
void FramedLink::Impl::reopen_ports(std::unique_lock<std::mutex>& lock) {
  for (const auto& line : lines) {
    if (!line->unplugged || ending) {
      continue;
    }
    auto port = transport::make_transport(line->port->port(), options.baud);
    lock.unlock();
    const Status opened = port->open();
    lock.lock();
    if (opened.ok()) {
      line->port = std::move(port);
      line->unplugged = false;
      line->cannot_open.clear();
      identify(*line);
      eventfd_write(wake.get(), 1);  // the listener's wait does not include the new port
    }
  }
}

void FramedLink::Impl::reopen() {
  std::unique_lock<std::mutex> lock(mutex);
  while (!ended.wait_for(lock, kReopenEvery, [this] { return ending; })) {
    reopen_ports(lock);
  }
}

void FramedLink::Impl::listen() {
  std::unique_lock<std::mutex> lock(mutex);
  std::vector<std::uint8_t> bytes;
  while (!ending) {
    ask();
    std::vector<pollfd> ready = {{wake.get(), POLLIN, 0}};
    for (const auto& line : lines) {
      ready.push_back({line->port->descriptor(), POLLIN, 0});  // poll() ignores -1
    }
    lock.unlock();
    ::poll(ready.data(), ready.size(), static_cast<int>(kReopenEvery.count()));
    const std::int64_t arrival_ns =
        std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now().time_since_epoch())
            .count();
    lock.lock();
    if (ready[0].revents != 0) {
      eventfd_t wakes = 0;
      eventfd_read(wake.get(), &wakes);
    }
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
  }
}

FramedLink::FramedLink(FramedOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}

FramedLink::~FramedLink() {
  close();
}

Status FramedLink::open() {
  close();
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  impl_->open_ports();
  impl_->ending = false;
  impl_->wake = drivers::Descriptor(eventfd(0, EFD_CLOEXEC));
  if (!impl_->wake.is_open()) {
    return Error{"framed link: cannot create an event descriptor"};
  }
  impl_->listener = std::thread([this] { impl_->listen(); });
  impl_->opener = std::thread([this] { impl_->reopen(); });
  return Done{};
}

Status FramedLink::send(const std::string& id, const gs::wire::Downlink& message) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  Line* const line = impl_->find(id);
  if (line == nullptr && impl_->known.count(id) == 0) {
    return Error{"framed link: no outlet " + id + " has joined"};
  }
  if (line == nullptr) {
    impl_->happenings.faults.push_back({id, "was not sent a message: it is not on any port"});
  } else if (!line->faulty && !impl_->send(*line, message)) {
    line->stream.note("does not accept messages on " + line->port->port());
  }
  return Done{};
}

Status FramedLink::poll(Happenings& happenings) {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  happenings.append(impl_->happenings);
  impl_->happenings.clear();
  for (const auto& line : impl_->lines) {
    for (std::string& fault : line->stream.take_faults()) {
      if (line->hello && !line->faulty) {
        happenings.faults.push_back({line->hello->id, std::move(fault), line->port->port()});
      }
    }
  }
  return Done{};
}

std::vector<Fault> FramedLink::missing() {
  std::vector<Fault> faults = unreachable();
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  for (const auto& line : impl_->lines) {
    if (!line->hello && line->cannot_open.empty() && !line->stream.unreadable().empty()) {
      faults.push_back({line->port->port(), line->stream.unreadable(), line->port->port()});
    }
  }
  return faults;
}

std::vector<Fault> FramedLink::unreachable() {
  const std::lock_guard<std::mutex> lock(impl_->mutex);
  std::vector<Fault> faults;
  for (const auto& line : impl_->lines) {
    if (!line->cannot_open.empty()) {
      const std::string& port = line->port->port();
      // The error begins with the port, as the fault does.
      faults.push_back({port, line->cannot_open.substr(port.size() + std::strlen(": ")), port});
    }
  }
  return faults;
}

void FramedLink::close() noexcept {
  {
    const std::lock_guard<std::mutex> lock(impl_->mutex);
    impl_->ending = true;
    if (impl_->wake.is_open()) {
      eventfd_write(impl_->wake.get(), 1);
    }
  }
  impl_->ended.notify_all();
  for (std::thread* const thread : {&impl_->listener, &impl_->opener}) {
    if (thread->joinable()) {
      thread->join();
    }
  }
  impl_->wake.close();
  impl_->lines.clear();
  impl_->known.clear();
  impl_->happenings.clear();
}

}  // namespace gsbench::link
