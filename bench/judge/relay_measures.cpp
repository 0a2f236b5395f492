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
  return stamped_after(c, loss_tick, c.first_word_open(loss_tick),
                       "the outlet did not say that it opened after the loss");
}

// From what the outlet stamps to what the bench sees.
Reading between(const Case& c, const record::Mark& said, std::int64_t seen_tick) {
  return number(c.milliseconds_between(said.tick, seen_tick),
                std::hypot(c.uncertainty.relay_sense_ms, c.outlet.clock.uncertainty_ms));
}

// From the decision, which the outlet stamps, to the contact, which the bench sees.
Reading operate_time(const Case& c) {
  const record::Mark* said = c.first_word_open();
  const auto opening = first_opening(c);
  if (said == nullptr || !opening) {
    return not_done("the relay was not opened");
  }
  return between(c, *said, *opening);
}

Reading report_difference(const Case& c) {
  const std::int64_t from_tick = c.first_loss_tick().value_or(0);
  const record::Mark* said = c.first_word_open(from_tick);
  const auto opening = first_opening(c, from_tick);
  if (said == nullptr && !opening) {
    return not_done("neither the outlet nor the relay sense reports an opening");
  }
  if (said == nullptr || !opening) {
    return not_done(said == nullptr ? "the contact opened and the outlet did not say so"
                                    : "the outlet said that it opened and the contact did not");
  }
  return between(c, *said, *opening);
}

Reading end(const Case& c) {
  return word(contact(c).closed ? "closed" : "open");
}

Reading edges(const Case& c) {
  return number(static_cast<double>(contact(c).changes.size()));
}

Reading chatter(const Case& c) {
  const Contact seen = contact(c);
  int extra = seen.idle_edges;
  for (const ContactChange& change : seen.changes) {
    extra += change.edges - 1;
  }
  return number(extra);
}

Reading command_delay(const Case& c) {
  const record::Mark* command = c.first_mark("command");
  if (command == nullptr) {
    return not_known("the profile sends this outlet no command");
  }
  const bool close = command->value > 0.5;
  for (const ContactChange& change : contact(c).changes) {
    if (change.first_tick >= command->tick && change.closed == close) {
      return number(c.milliseconds_between(command->tick, change.first_tick),
                    c.uncertainty.relay_sense_ms);
    }
  }
  return not_done("the contact did not follow the command");
}

Reading trip_time(const Case& c) {
  const auto opening = first_opening(c);
  return opening ? number(c.seconds(*opening), 1e-3 * c.uncertainty.relay_sense_ms)
                 : not_done("the contact did not open");
}

// What only the relay sense can tell.
template <Reading (*kRead)(const Case&)>
Reading seen(const Case& c) {
  return c.outlet.relay_sensed ? kRead(c) : not_known("no relay sense looks at its contact");
}

}  // namespace

Readings contact_readings() {
  return {
      {"relay.delay", seen<after_loss<relay_delay>>},
      {"relay.end", seen<end>},
      {"relay.edges", seen<edges>},
      {"relay.chatter", seen<chatter>},
      {"command.delay", seen<command_delay>},
      {"trip.time", seen<trip_time>},
  };
}

Readings relay_readings() {
  return {
      {"relay.delay_reported", after_loss<delay_reported>},
      {"relay.report_difference", seen<report_difference>},
      {"relay.operate_time", seen<operate_time>},
  };
}

}  // namespace gsbench::judge
