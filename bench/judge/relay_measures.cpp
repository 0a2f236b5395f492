#include <algorithm>
#include <cmath>
#include <optional>

#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

std::optional<std::int64_t> first_opening(const Case& c, std::int64_t from_tick = 0) {
  for (const ContactChange& change : contact(c).changes) {
    if (!change.closed && change.first_tick >= from_tick) {
      return change.first_tick;
    }
  }
  return std::nullopt;
}

Reading relay_delay(const Case& c, std::int64_t loss_tick) {
  const auto opening = first_opening(c, loss_tick);
  if (!opening) {
    return not_done("the contact did not open after the loss");
  }
  return number(c.milliseconds_between(loss_tick, *opening), c.uncertainty.relay_sense_ms);
}

Reading delay_reported(const Case& c, std::int64_t loss_tick) {
  return stamped_after(c, loss_tick, c.first_reported_opening(loss_tick),
                       "the outlet did not report a command to open after the loss");
}

// Time from the reported command to open to the opening that the relay sense sees.
Reading between(const Case& c, const record::Mark& reported, std::int64_t sensed_tick) {
  return number(c.milliseconds_between(reported.tick, sensed_tick),
                std::hypot(c.uncertainty.relay_sense_ms, c.outlet.clock.uncertainty_ms));
}

Reading operate_time(const Case& c) {
  const record::Mark* reported = c.first_reported_opening();
  const auto opening = first_opening(c);
  if (reported == nullptr || !opening) {
    return not_done("no opening was both sensed and reported");
  }
  return between(c, *reported, *opening);
}

Reading report_difference(const Case& c) {
  const std::int64_t from_tick = c.first_loss_tick().value_or(0);
  const record::Mark* reported = c.first_reported_opening(from_tick);
  const auto opening = first_opening(c, from_tick);
  if (reported == nullptr && !opening) {
    return not_done("no opening was sensed or reported");
  }
  if (reported == nullptr || !opening) {
    return not_done(reported == nullptr
                        ? "the contact opened but the outlet did not report it"
                        : "the outlet reported a command to open but the contact did not open");
  }
  return between(c, *reported, *opening);
}

Reading end(const Case& c) {
  return text(contact(c).closed ? "closed" : "open");
}

Reading edges(const Case& c) {
  return number(static_cast<double>(contact(c).changes.size()));
}

Reading chatter(const Case& c) {
  const Contact sensed = contact(c);
  int extra = sensed.idle_edges;
  for (const ContactChange& change : sensed.changes) {
    extra += change.edges - 1;
  }
  return number(extra);
}

Reading command_delay(const Case& c) {
  const record::Mark* command = c.first_mark("command");
  if (command == nullptr) {
    return not_known("the profile sends no command to this outlet");
  }
  const bool close = command->value > 0.5;
  for (const ContactChange& change : contact(c).changes) {
    if (change.first_tick >= command->tick && change.closed == close) {
      return number(c.milliseconds_between(command->tick, change.first_tick),
                    c.uncertainty.command_ms);
    }
  }
  return not_done("the contact did not follow the command");
}

Reading trip_time(const Case& c) {
  const auto opening = first_opening(c);
  return opening ? number(c.seconds(*opening), 1e-3 * c.uncertainty.relay_sense_ms)
                 : not_done("the contact did not open");
}

// The frequency changes within the uncertainty of the opening's time, and the source plays it with
// a deviation of its own. Both are bounds, and not independent: the sum is taken.
Reading operate_hz(const Case& c) {
  const auto opening = first_opening(c);
  if (!opening) {
    return not_done("the contact did not open");
  }
  const double at_s = c.seconds(*opening);
  const double within_s = 1e-3 * c.uncertainty.relay_sense_ms;
  const double opened_hz = c.reference.frequency_hz(at_s);
  return number(opened_hz,
                std::max(std::fabs(c.reference.frequency_hz(at_s - within_s) - opened_hz),
                         std::fabs(c.reference.frequency_hz(at_s + within_s) - opened_hz)) +
                    1e-3 * c.uncertainty.frequency_mhz);
}

// A measure that requires a relay sense.
template <Reading (*kRead)(const Case&)>
Reading with_sense(const Case& c) {
  return c.outlet.relay_sensed ? kRead(c) : not_known("no relay sense is connected to this outlet");
}

}  // namespace

Readings contact_readings() {
  return {
      {"relay.delay", with_sense<after_loss<relay_delay>>},
      {"relay.end", with_sense<end>},
      {"relay.edges", with_sense<edges>},
      {"relay.chatter", with_sense<chatter>},
      {"command.delay", with_sense<command_delay>},
      {"trip.time", with_sense<trip_time>},
      {"relay.operate_hz", with_sense<operate_hz>},
  };
}

Readings relay_readings() {
  return {
      {"relay.delay_reported", after_loss<delay_reported>},
      {"relay.report_difference", with_sense<report_difference>},
      {"relay.operate_time", with_sense<operate_time>},
  };
}

}  // namespace gsbench::judge
