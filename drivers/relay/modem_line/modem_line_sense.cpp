#include <relay_modem_line/modem_line_sense.hpp>
#include <sys/ioctl.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>

namespace gsbench::relay {

using drivers::Descriptor;
using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using std::chrono::steady_clock;

namespace {

constexpr auto kReadEvery = std::chrono::milliseconds(1);

int bit_of(ModemLine line) {
  switch (line) {
    case ModemLine::kCts:
      return TIOCM_CTS;
    case ModemLine::kDsr:
      return TIOCM_DSR;
    case ModemLine::kDcd:
      return TIOCM_CAR;
  }
  return 0;
}

double seconds(steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

std::int64_t nanoseconds(steady_clock::duration duration) {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count();
}

}  // namespace

// One serial port and the thread that reads its lines.
class ModemLineSense::Port {
 public:
  struct Found {
    Edge edge;
    double half_s;  // of the interval that the edge lies in
  };

  Port(std::string name, const ModemLineSystem& system, steady_clock::time_point epoch)
      : name_(std::move(name)), system_(system), epoch_(epoch) {}
  ~Port() {
    ending_ = true;
    if (reading_.joinable()) {
      reading_.join();
    }
  }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  const std::string& name() const { return name_; }
  void add(std::size_t channel, ModemLine line) { lines_.push_back({channel, bit_of(line)}); }

  Status open() {
    if (Status opened = system_.open(name_).move_to(descriptor_); !opened.ok()) {
      return opened;
    }
    int outputs = TIOCM_RTS | TIOCM_DTR;
    if (system_.ioctl(descriptor_.get(), TIOCMBIS, &outputs) != 0) {
      return failure("switching RTS and DTR on");
    }
    last_start_ = system_.now();
    if (Status first = read(); !first.ok()) {
      return first;
    }
    reading_ = std::thread([this] { read_until_end(); });
    return Done{};
  }

  // Moves the edges found so far to the end of `found`.
  Status poll(std::vector<Found>& found) {
    const std::lock_guard<std::mutex> lock(mutex_);
    found.insert(found.end(), found_.begin(), found_.end());
    found_.clear();
    return lost_ ? Status(Error{*lost_}) : Status(Done{});
  }

 private:
  struct Line {
    std::size_t channel;
    int bit;
    bool closed = true;
  };

  Error failure(const char* doing) const {
    return {fmt::format("{}: {}: {}", name_, doing, std::strerror(errno))};
  }

  Status read() {
    const steady_clock::time_point start = system_.now();
    int bits = 0;
    if (system_.ioctl(descriptor_.get(), TIOCMGET, &bits) != 0) {
      return failure("reading its modem lines");
    }
    const steady_clock::duration interval = system_.now() - last_start_;
    const steady_clock::time_point middle = last_start_ + interval / 2;
    last_start_ = start;
    const std::int64_t count = nanoseconds(middle - epoch_);
    for (Line& line : lines_) {
      const bool closed = (bits & line.bit) != 0;
      if (closed != line.closed) {
        line.closed = closed;
        const std::lock_guard<std::mutex> lock(mutex_);
        found_.push_back({{line.channel, count, closed}, seconds(interval) / 2.0});
      }
    }
    return Done{};
  }

  void read_until_end() {
    while (!ending_) {
      system_.sleep(kReadEvery);
      if (const Status done = read(); !done.ok()) {
        const std::lock_guard<std::mutex> lock(mutex_);
        lost_ = done.error();
        return;
      }
    }
  }

  std::string name_;
  const ModemLineSystem& system_;
  steady_clock::time_point epoch_;
  std::vector<Line> lines_;
  Descriptor descriptor_;
  steady_clock::time_point last_start_;  // of the last reading
  std::mutex mutex_;
  std::vector<Found> found_;         // under mutex_
  std::optional<std::string> lost_;  // under mutex_
  std::atomic<bool> ending_{false};
  std::thread reading_;
};

ModemLineSense::ModemLineSense(const ModemLineOptions& options, const source::Source& source,
                               ModemLineSystem system)
    : options_(options),
      source_(source),
      system_(std::move(system)),
      epoch_(system_.now()),
      largest_half_s_(seconds(kReadEvery) / 2.0) {
  for (std::size_t channel = 0; channel < options.contacts.size(); ++channel) {
    const ModemLineContact& contact = options.contacts[channel];
    auto port = std::find_if(ports_.begin(), ports_.end(),
                             [&](const auto& known) { return known->name() == contact.port; });
    if (port == ports_.end()) {
      port = ports_.insert(port, std::make_unique<Port>(contact.port, system_, epoch_));
    }
    (*port)->add(channel, contact.line);
  }
}

ModemLineSense::~ModemLineSense() = default;

Status ModemLineSense::open() {
  if (is_open_) {
    return Done{};
  }
  for (const auto& port : ports_) {
    if (Status opened = port->open(); !opened.ok()) {
      return opened;
    }
  }
  is_open_ = true;
  return Done{};
}

Alignment ModemLineSense::alignment() const {
  const auto rate_hz = static_cast<double>(options_.sample_rate_hz);
  const double own_s = largest_half_s_ + options_.adapter_latency_s;
  Alignment alignment;
  alignment.counts_per_tick = 1e9 / rate_hz;
  // Half a tick: an edge is rounded to a tick, and so is an instant.
  alignment.uncertainty_ticks = (own_s + source_.limits().host_clock_uncertainty_s) * rate_hz + 0.5;
  alignment.uncertainty_between_ticks = own_s * rate_hz + 1.0;
  if (const std::optional<source::HostClock> clock = source_.host_clock()) {
    alignment.counts_per_tick = 1e9 * clock->tick_s;
    alignment.count_at_tick_0 = 1e9 * seconds(clock->tick_0 - epoch_);
    alignment.uncertainty_ticks = (own_s + clock->uncertainty_s) / clock->tick_s + 0.5;
  }
  return alignment;
}

std::string ModemLineSense::not_known_yet() const {
  return "how late the source starts and how far its clock drifts from this machine's, and "
         "readings "
         "that are more than 1 ms apart";
}

std::optional<std::int64_t> ModemLineSense::count_at(steady_clock::time_point time) const {
  return nanoseconds(time - epoch_);
}

Status ModemLineSense::poll(std::vector<Edge>& edges) {
  std::vector<Port::Found> found;
  Status all = Done{};
  for (const auto& port : ports_) {
    Status polled = port->poll(found);
    all = polled.ok() ? all : polled;
  }
  for (const Port::Found& one : found) {
    largest_half_s_ = std::max(largest_half_s_, one.half_s);
    edges.push_back(one.edge);
  }
  return all;
}

}  // namespace gsbench::relay
