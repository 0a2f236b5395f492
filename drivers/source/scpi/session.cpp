// The order of the steps, the output, and the trigger.
#include "session.hpp"

#include <algorithm>
#include <functional>
#include <thread>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using transport::Clock;

namespace {

constexpr auto kBetweenTries = std::chrono::milliseconds(200);

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Session::Session(const Instrument& instrument, const std::string& port, int baud, int channel,
                 source::Interrupt& interrupt)
    : instrument_(instrument),
      port_(port),
      interrupt_(interrupt),
      connection_(instrument, port, baud, interrupt),
      values_{{"channel", std::to_string(channel)}, {"name", "gsbench"}, {"offset_v", "0"}} {}

Error Session::error(const std::string& what) const {
  return {fmt::format("{} at {}: {}", instrument_.title, port_, what)};
}

Status Session::connect() {
  return connection_.is_open() ? Status(Done{}) : connection_.open();
}

// One reconnection. Only for steps that may be repeated.
Status Session::reconnecting(const std::function<Status()>& step) {
  Status done = connect();
  if (done.ok()) {
    done = step();
  }
  if (done.ok() || connection_.is_open() || connection_.speaks_to_another() ||
      interrupt_.is_set()) {
    return done;
  }
  const std::string first = done.error();
  if (Status again = connect(); !again.ok()) {
    return error(fmt::format("{}; and then {}", first, again.error()));
  }
  return step();
}

Status Session::load(const Plan& plan, const source::Progress& progress) {
  values_.resize(3);  // the fixed ones
  values_.emplace_back("points", std::to_string(plan.codes.size()));
  values_.emplace_back("bytes", std::to_string(plan.bytes()));
  values_.emplace_back("rate_hz", number_text(plan.rate_hz));
  values_.emplace_back("frequency_hz", number_text(plan.frequency_hz));
  values_.emplace_back("amplitude_vpp", number_text(plan.amplitude_vpp));
  questions_ = watched_queries();
  next_question_ = 0;
  lost_ = false;
  return reconnecting([&] { return load_once(plan, progress); });
}

Status Session::load_once(const Plan& plan, const source::Progress& progress) {
  const std::function<Status()> steps[] = {
      [&] { return switch_output(false); },
      [&] { return reset(); },
      [&] { return forget_errors(); },
      [&] { return set(When::kBeforeUpload); },
      [&] { return clear_memory(); },
      [&] { return upload(plan, progress); },
      [&] { return connection_.pause(instrument_.timing.upload_s); },
      [&] { return output_still_off(); },
      [&] { return verify(plan); },
      [&] { return set(When::kAfterUpload); },
      [&] { return all_at(false); },
      [&] { return expect_output(false); }};
  for (const auto& step : steps) {
    if (Status done = step(); !done.ok()) {
      return done;
    }
  }
  return Done{};
}

Status Session::reset() {
  for (const std::string& command : instrument_.dialect.reset) {
    if (Status sent = connection_.send(text(command)); !sent.ok()) {
      return sent;
    }
  }
  return connection_.pause(instrument_.timing.reset_s);
}

// After an upload, which may have switched it on.
Status Session::output_still_off() {
  return instrument_.has(Quirk::kUploadSwitchesOn) ? switch_output(false) : expect_output(false);
}

Status Session::check_settings() {
  return reconnecting([&] { return all_at(false); });
}

Status Session::check_playing() {
  return reconnecting([&] {
    Status on = expect_output(true);
    return on.ok() ? all_at(true) : on;
  });
}

Status Session::expect_output(bool on) {
  const Result<std::string> answer = connection_.ask(text(instrument_.dialect.output.query));
  if (!answer.ok()) {
    return error(fmt::format("output: {}", answer.error()));
  }
  return compare_output(on, answer.value());
}

Status Session::compare_output(bool on, const std::string& answer) const {
  const Dialect& dialect = instrument_.dialect;
  const Result<std::string> state = value_in(answer, dialect.output.field);
  if (!state.ok()) {
    return error(fmt::format("output: the answer {}", state.error()));
  }
  if (is_one_of(state.value(), text(on ? dialect.is_on : dialect.is_off))) {
    return Done{};
  }
  const bool other = is_one_of(state.value(), text(on ? dialect.is_off : dialect.is_on));
  return error(
      other ? fmt::format("the output is {}, but {} was set", on ? "off" : "on", on ? "on" : "off")
            : fmt::format("the output is \"{}\", neither on nor off", printable(state.value())));
}

Status Session::switch_output(bool on) {
  const Dialect& dialect = instrument_.dialect;
  Status sent = connection_.send(text(on ? dialect.output_on : dialect.output_off));
  return sent.ok() ? expect_output(on) : sent;
}

Status Session::switch_on() {
  return reconnecting([&] { return switch_output(true); });
}

// Not repeated: a second trigger would play the waveform twice.
Result<Triggered> Session::trigger() {
  const Clock::time_point asked = Clock::now();
  if (Status on = expect_output(true); !on.ok()) {
    return Error{on.error()};
  }
  Triggered triggered;
  triggered.sent = Clock::now();
  if (Status sent = connection_.send_at_once(text(instrument_.dialect.trigger)); !sent.ok()) {
    return error(sent.error());
  }
  // The answer comes after the trigger was executed.
  if (Status on = expect_output(true); !on.ok()) {
    return Error{on.error()};
  }
  triggered.late_s = std::max(
      0.0, seconds_between(triggered.sent, Clock::now()) - seconds_between(asked, triggered.sent));
  Status clean = expect_no_error("the trigger");
  return clean.ok() ? Result<Triggered>(triggered) : Error{clean.error()};
}

Status Session::make_safe(double longest_s) {
  const Clock::time_point end = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                   std::chrono::duration<double>(longest_s));
  for (;;) {
    Status safe = connect();
    if (safe.ok()) {
      safe = switch_output(false);
    } else if (!connection_.speaks_to_another() && connection_.open_mute().ok()) {
      // It is there but does not answer: it may still obey.
      static_cast<void>(connection_.send(text(instrument_.dialect.output_off)).ok());
    }
    // Others may connect now; many instruments serve one client at a time.
    connection_.close();
    if (safe.ok() || connection_.speaks_to_another() || Clock::now() + kBetweenTries > end) {
      return safe;
    }
    std::this_thread::sleep_for(kBetweenTries);
  }
}

}  // namespace gsbench::scpi
