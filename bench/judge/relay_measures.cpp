#include <cmath>
#include <optional>

#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

const record::Mark* first_word_open(const Case& c, std::int64_t from_tick = 0) {
  for (const record::Mark& mark : c.outlet.marks) {
    if (mark.kind == "relay.word" && mark.value < 0.5 && mark.tick >= from_tick) {
      return &mark;
    }
  }
  return nullptr;
}

std::optional<std::int64_t> first_opening(const Case& c, std::int64_t from_tick = 0) {
  for (const ContactChange& change : contact(c).changes) {
    if (!change.closed && change.first_tick >= from_tick) {
      return change.first_tick;
    }
  }
  return std::nullopt;
}

Reading relay_delay(const Case& c) {
  const auto loss = c.first_loss_tick();
  if (!loss) {
    return not_known("the profile plays no loss");
  }
  const auto opening = first_opening(c, *loss);
  if (!opening) {
    return not_done("the contact did not open after the loss");
  }
  return number(c.milliseconds_between(*loss, *opening), c.uncertainty.relay_sense_ms);
}

Reading delay_by_word(const Case& c) {
  const auto loss = c.first_loss_tick();
  if (!loss) {
    return not_known("the profile plays no loss");
  }
  const record::Mark* said = first_word_open(c, *loss);
  if (said == nullptr) {
    return not_done("the outlet did not say that it opened after the loss");
  }
  return number(c.milliseconds_between(*loss, said->tick), c.outlet.clock.uncertainty_ms);
}

// From the decision, which the outlet stamps, to the contact, which the bench sees.
Reading operate_time(const Case& c) {
  const record::Mark* said = first_word_open(c);
  const auto opening = first_opening(c);
  if (said == nullptr || !opening) {
    return not_done("the relay was not opened");
  }
  return number(c.milliseconds_between(said->tick, *opening),
                std::hypot(c.uncertainty.relay_sense_ms, c.outlet.clock.uncertainty_ms));
}

Reading word_difference(const Case& c) {
  const auto loss = c.first_loss_tick();
  const record::Mark* said = first_word_open(c, loss.value_or(0));
  const auto opening = first_opening(c, loss.value_or(0));
  if (said == nullptr && !opening) {
    return not_done("neither the outlet nor the relay sense reports an opening");
  }
  if (said == nullptr || !opening) {
    return not_done(said == nullptr ? "the contact opened and the outlet did not say so"
                                    : "the outlet said that it opened and the contact did not");
  }
  return number(c.milliseconds_between(said->tick, *opening),
                std::hypot(c.uncertainty.relay_sense_ms, c.outlet.clock.uncertainty_ms));
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
      {"relay.delay", seen<relay_delay>},     {"relay.end", seen<end>},
      {"relay.edges", seen<edges>},           {"relay.chatter", seen<chatter>},
      {"command.delay", seen<command_delay>}, {"trip.time", seen<trip_time>},
  };
}

Readings relay_readings() {
  return {
      {"relay.delay_by_word", delay_by_word},
      {"relay.word_difference", seen<word_difference>},
      {"relay.operate_time", seen<operate_time>},
  };
}

}  // namespace gsbench::judge
