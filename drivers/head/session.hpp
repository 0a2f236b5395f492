// One session with a head, shared by source and relay sense: connection, state of the head, and
// where the stimulus is in its stream.
#pragma once

#include "connection.hpp"
#include "host_clock.hpp"
#include "plan.hpp"
#include <head_driver/head.hpp>

#include <cstdint>
#include <optional>

#include <drivers/result.hpp>

namespace gsbench::head {

struct Session {
  explicit Session(const HeadOptions& options);

  // Opens the port and identifies the head. Its output is off then.
  drivers::Status connect(source::Interrupt& interrupt);
  // Blocks until the head is armed, 0.5 s at most.
  drivers::Status arm(source::Interrupt& interrupt);
  // Reads what arrives. Blocks until a byte has arrived, at most until `until`. Asks for a status
  // if none has come for a while. An error if the head does not play what it should, and why.
  drivers::Status listen(Clock::time_point until);
  // Output off, confirmed. If the connection is lost, it is opened again, once.
  drivers::Status switch_off();

  bool is_armed() const { return run.has_value(); }
  // Samples of the stream that have been at the output.
  std::int64_t samples_played() const;
  // The next sample of the stream that the head has no room for.
  std::int64_t room_until() const;

  const HeadOptions options;
  const Amplitude amplitude;
  Connection connection;
  protocol::Hello hello;
  std::optional<std::uint32_t> run;  // armed, or later
  bool has_played = false;
  std::uint32_t missed_at_arm = 0;            // edges
  std::optional<std::int64_t> tick_0_sample;  // from start() on
  HostClockEstimate host_clock;

 private:
  drivers::Status health() const;
  drivers::Error failure(const std::string& what) const;
  drivers::Status stop_once();

  Clock::time_point heard_;  // the newest status
  Clock::time_point asked_;  // the newest ping
};

}  // namespace gsbench::head
