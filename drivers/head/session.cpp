#include "session.hpp"

#include "identity.hpp"

#include <random>

#include <fmt/format.h>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

using namespace std::chrono_literals;

constexpr auto kArmPatience = 500ms;
constexpr auto kAskedAfter = 12ms;  // of silence; a head that plays sends a status every 8 ms
constexpr auto kLost = 500ms;       // of silence

std::uint32_t any_number() {
  std::random_device device;
  return device();
}

}  // namespace

Session::Session(const HeadOptions& o)
    : options(o), amplitude(o), connection(o.port, o.baud), host_clock(o.clock_ppm) {}

Error Session::failure(const std::string& what) const {
  return {options.port + ": " + what};
}

Status Session::connect(source::Interrupt& interrupt) {
  run.reset();
  tick_0_sample.reset();
  has_played = false;
  host_clock = HostClockEstimate(options.clock_ppm);
  if (Status opened = connection.open(); !opened.ok()) {
    return opened;
  }
  if (Status identified = connection.identify(interrupt).move_to(hello); !identified.ok()) {
    return identified;
  }
  return check(hello, options);
}

Status Session::arm(source::Interrupt& interrupt) {
  const std::uint32_t number = any_number();
  if (Status sent = connection.arm(number); !sent.ok()) {
    return sent;
  }
  for (const auto end = Clock::now() + kArmPatience; Clock::now() < end;) {
    if (interrupt.is_set()) {
      return failure(source::Interrupt::error().message);
    }
    // Also finds the loss of the message before.
    if (Status asked = connection.ping(); !asked.ok()) {
      return asked;
    }
    if (Status received = connection.receive(Clock::now() + kAskedAfter); !received.ok()) {
      return received;
    }
    const auto& status = connection.status();
    if (status && status->run == number && status->state == protocol::State::kArmed) {
      run = number;
      missed_at_arm = status->edges_missed;
      heard_ = connection.status_arrival();
      asked_ = heard_;
      return Done{};
    }
  }
  return failure("the head cannot be armed: it does not answer");
}

Status Session::listen(Clock::time_point until) {
  const auto before = connection.status_arrival();
  Status received = connection.receive(until);
  if (connection.status_arrival() != before) {
    heard_ = connection.status_arrival();
    const auto& status = *connection.status();
    has_played = has_played || status.state == protocol::State::kPlaying;
    if (status.state == protocol::State::kPlaying && status.count > 0) {
      host_clock.add(static_cast<double>(status.count) /
                         (static_cast<double>(hello.counts_per_sample) * protocol::kSampleRate_hz),
                     heard_);
    }
  }
  // A fault is the cause of what follows it.
  if (Status healthy = health(); !healthy.ok()) {
    return healthy;
  }
  if (!received.ok()) {
    return received;
  }
  const auto now = Clock::now();
  if (now - heard_ > kLost) {
    return failure("the head has not answered for 0.5 s");
  }
  if (now - heard_ > kAskedAfter && now - asked_ > kAskedAfter) {
    asked_ = now;
    return connection.ping();
  }
  return Done{};
}

Status Session::health() const {
  const protocol::Status& status = *connection.status();
  if (status.run != *run) {
    return failure("the head has restarted or was armed by another program");
  }
  switch (status.state) {
    case protocol::State::kPlaying:
      break;
    case protocol::State::kArmed:
      if (has_played) {
        return failure("the head has restarted");
      }
      break;
    case protocol::State::kOff:
      return failure("another program has switched the head's output off");
    case protocol::State::kFaulted:
      switch (status.fault) {
        case protocol::Fault::kUnderrun:
          return failure(
              fmt::format("the head has switched its output off: sample {} was not "
                          "there in time (underrun); this machine or the connection "
                          "was too slow",
                          status.position));
        case protocol::Fault::kWatchdog:
          return failure(
              fmt::format("the head has switched its output off: it heard nothing from "
                          "the bench for {} ms (watchdog)",
                          hello.watchdog_ms));
        case protocol::Fault::kHardware:
        case protocol::Fault::kNone:
          return failure(
              "the head has switched its output off: its DAC did not get its codes in time");
      }
  }
  return Done{};
}

Status Session::stop_once() {
  if (!connection.is_open()) {
    if (Status opened = connection.open(); !opened.ok()) {
      return opened;
    }
  }
  Status off = connection.switch_off();
  connection.close();
  return off;
}

Status Session::switch_off() {
  run.reset();
  Status off = stop_once();
  if (!off.ok()) {
    off = stop_once();
  }
  if (!off.ok()) {
    return Error{fmt::format(
        "output state unknown: {}. A DAC head switches its output off by itself within 250 ms of "
        "the last message. If in doubt, switch its supply off by hand; check the voltage at the "
        "outlets "
        "before touching them",
        off.error())};
  }
  return off;
}

std::int64_t Session::samples_played() const {
  const std::int64_t counts = connection.status()->count;
  return counts <= 0 ? 0 : counts / hello.counts_per_sample;
}

std::int64_t Session::room_until() const {
  return static_cast<std::int64_t>(connection.status()->position) + hello.buffer_samples;
}

}  // namespace gsbench::head
