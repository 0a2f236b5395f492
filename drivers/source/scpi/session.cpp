#include "session.hpp"

#include "codes.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <thread>

#include <fmt/format.h>

namespace gsbench::scpi {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using transport::Clock;

namespace {

// Deepest error queue of the instruments here has 20 entries.
constexpr int kMostErrors = 100;
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
template <class Step>
Status Session::reconnecting(const Step& step) {
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
  return reconnecting([&] { return load_once(plan, progress); });
}

Status Session::load_once(const Plan& plan, const source::Progress& progress) {
  Status done = switch_output(false);
  if (done.ok()) {
    for (const std::string& command : instrument_.dialect.reset) {
      if (done.ok()) {
        done = connection_.send(text(command));
      }
    }
  }
  if (done.ok()) {
    done = connection_.pause(instrument_.timing.reset_s);
  }
  if (done.ok()) {
    done = forget_errors();
  }
  if (done.ok()) {
    done = set(When::kBeforeUpload);
  }
  if (done.ok() && !instrument_.dialect.clear.empty()) {
    done = connection_.send(text(instrument_.dialect.clear));
    if (done.ok()) {
      done = connection_.pause(instrument_.timing.packet_s);
    }
    if (done.ok() && instrument_.has(Quirk::kUploadSwitchesOn)) {
      done = switch_output(false);
    }
  }
  if (done.ok()) {
    done = upload(plan, progress);
  }
  if (done.ok()) {
    done = connection_.pause(instrument_.timing.upload_s);
  }
  if (done.ok()) {
    done = instrument_.has(Quirk::kUploadSwitchesOn) ? switch_output(false) : expect_output(false);
  }
  if (done.ok()) {
    done = verify(plan);
  }
  if (done.ok()) {
    done = set(When::kAfterUpload);
  }
  if (done.ok()) {
    done = all_at(false);
  }
  return done.ok() ? expect_output(false) : done;
}

Status Session::upload(const Plan& plan, const source::Progress& progress) {
  if (instrument_.format.block == Block::kPackets) {
    return upload_packets(plan, progress);
  }
  const std::vector<std::uint8_t> bytes =
      bytes_of(plan.codes.data(), plan.codes.size(), instrument_);
  std::string header = text(instrument_.dialect.upload);
  if (instrument_.format.block == Block::kBlock) {
    const std::string count = std::to_string(bytes.size());
    header += fmt::format("#{}{}", count.size(), count);
  }
  return connection_.send_block(header, bytes, [&](std::size_t sent) {
    if (progress) {
      progress(static_cast<double>(sent) / static_cast<double>(bytes.size()));
    }
  });
}

Status Session::upload_packets(const Plan& plan, const source::Progress& progress) {
  const std::size_t total = plan.codes.size();
  const auto most = static_cast<std::size_t>(instrument_.memory.packet_points);
  const auto fewest = static_cast<std::size_t>(instrument_.memory.fewest_points);
  for (std::size_t at = 0; at < total;) {
    std::size_t count = std::min(most, total - at);
    // The last packet must not be too short.
    if (const std::size_t rest = total - at - count; rest > 0 && rest < fewest) {
      count -= fewest - rest;
    }
    const bool last = at + count == total;
    const std::vector<std::uint8_t> bytes = bytes_of(plan.codes.data() + at, count, instrument_);
    const std::string size = std::to_string(bytes.size());
    const std::string header =
        filled(text(instrument_.dialect.upload),
               {{"part", last ? instrument_.dialect.last_part : instrument_.dialect.more_part}}) +
        fmt::format("#{}{}", size.size(), size);
    if (Status sent = connection_.send_block(header, bytes, {}); !sent.ok()) {
      return sent;
    }
    if (Status paused = connection_.pause(instrument_.timing.packet_s); !paused.ok()) {
      return paused;
    }
    at += count;
    if (progress) {
      progress(static_cast<double>(at) / static_cast<double>(total));
    }
  }
  return Done{};
}

Status Session::verify(const Plan& plan) {
  if (Status clean = expect_no_error("the upload"); !clean.ok()) {
    return clean;
  }
  if (instrument_.verification != Verification::kReadBack) {
    return Done{};
  }
  const Result<std::vector<std::uint8_t>> read =
      connection_.ask_waveform(text(instrument_.dialect.read_back));
  if (!read.ok()) {
    return error(fmt::format("the waveform cannot be read back: {}", read.error()));
  }
  const std::vector<std::uint8_t> sent =
      bytes_of(plan.codes.data(), plan.codes.size(), instrument_);
  const std::vector<std::uint8_t>& stored = read.value();
  if (stored.size() != sent.size()) {
    return error(fmt::format("the waveform was not stored as sent: {} bytes instead of {}",
                             stored.size(), sent.size()));
  }
  const auto differs = std::mismatch(sent.begin(), sent.end(), stored.begin());
  if (differs.first != sent.end()) {
    return error(
        fmt::format("the waveform was not stored as sent: byte {} is 0x{:02X} instead of "
                    "0x{:02X}",
                    differs.first - sent.begin(), *differs.second, *differs.first));
  }
  return Done{};
}

Status Session::set(When when) {
  std::vector<const Setting*> sent;
  for (const Setting& setting : instrument_.settings) {
    if (setting.when != when) {
      continue;
    }
    for (const std::string& command : setting.commands) {
      if (Status done = connection_.send(text(command)); !done.ok()) {
        return done;
      }
    }
    sent.push_back(&setting);
  }
  Status same = ask_back(sent);
  return same.ok() ? expect_no_error("the settings") : same;
}

Status Session::compare(const Setting& setting, const std::string& answer) const {
  const Result<std::string> found = value_in(answer, setting.asked.field);
  if (!found.ok()) {
    return setting.may_be_missing
               ? Status(Done{})
               : error(fmt::format("{}: the answer {}", setting.name, found.error()));
  }
  const std::string expected = text(setting.expected);
  bool same = false;
  if (setting.compare == Compare::kText) {
    same = is_one_of(found.value(), expected);
  } else {
    const Result<double> number = number_in(found.value(), setting.unit);
    const Result<double> wanted = number_in(expected, "");
    if (!number.ok() || !wanted.ok()) {
      return error(
          fmt::format("{}: {}", setting.name, number.ok() ? wanted.error() : number.error()));
    }
    const double tolerance =
        std::max(setting.tolerance, 1e-6 * setting.tolerance_ppm * std::fabs(wanted.value()));
    same = std::fabs(number.value() - wanted.value()) <= tolerance;
  }
  if (same) {
    return Done{};
  }
  return error(
      fmt::format("{} is {}, but {} was set", setting.name, printable(found.value()), expected));
}

// Settings with the same query share one answer.
Status Session::ask_back(const std::vector<const Setting*>& settings) {
  std::map<std::string, std::string> answers;
  for (const Setting* const setting : settings) {
    const std::string query = text(setting->asked.query);
    if (answers.count(query) == 0) {
      Result<std::string> answer = connection_.ask(query);
      if (!answer.ok()) {
        return error(fmt::format("{}: {}", setting->name, answer.error()));
      }
      answers[query] = answer.take();
    }
    if (Status same = compare(*setting, answers[query]); !same.ok()) {
      return same;
    }
  }
  return Done{};
}

Status Session::all_at(bool playing) {
  std::vector<const Setting*> asked;
  for (const Setting& setting : instrument_.settings) {
    if (!playing || setting.watched) {
      asked.push_back(&setting);
    }
  }
  return ask_back(asked);
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
  const Dialect& dialect = instrument_.dialect;
  const std::string query = text(dialect.output.query);
  const Result<std::string> answer = connection_.ask(query);
  if (!answer.ok()) {
    return error(fmt::format("output: {}", answer.error()));
  }
  const Result<std::string> state = value_in(answer.value(), dialect.output.field);
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

// Errors that were there before are not ours.
Status Session::forget_errors() {
  if (instrument_.dialect.next_error.empty()) {
    return Done{};
  }
  for (int i = 0; i < kMostErrors; ++i) {
    const Result<std::string> next = connection_.ask(text(instrument_.dialect.next_error));
    if (!next.ok()) {
      return error(fmt::format("error queue: {}", next.error()));
    }
    const Result<std::string> number = value_in(next.value(), "1");
    const Result<double> code = number_in(number.ok() ? number.value() : next.value(), "");
    if (!code.ok()) {
      return error(fmt::format("error queue: {}", code.error()));
    }
    if (code.value() == 0.0) {
      return Done{};
    }
  }
  return error(fmt::format("the error queue is not empty after {} entries", kMostErrors));
}

Status Session::expect_no_error(const std::string& after) {
  if (instrument_.dialect.next_error.empty()) {
    return Done{};
  }
  const Result<std::string> next = connection_.ask(text(instrument_.dialect.next_error));
  if (!next.ok()) {
    return error(fmt::format("error queue: {}", next.error()));
  }
  const Result<std::string> number = value_in(next.value(), "1");
  const Result<double> code = number_in(number.ok() ? number.value() : next.value(), "");
  if (code.ok() && code.value() == 0.0) {
    return Done{};
  }
  return error(fmt::format("reports an error after {}: {}", after, printable(next.value())));
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
