#include "arrivals.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include <link/version_text.hpp>

namespace gsbench::link {

namespace {

constexpr std::string_view kPrefix = "gs/";

// Of the topics that the bench subscribes to. Empty: an outlet without an id.
std::string_view id_in(std::string_view topic) {
  topic.remove_prefix(std::min(kPrefix.size(), topic.size()));
  return topic.substr(0, topic.find('/'));
}

std::string instance_text(std::uint32_t instance) {
  char text[16];
  std::snprintf(text, sizeof text, "0x%08X", static_cast<unsigned>(instance));
  return text;
}

std::string reports_id(const gs::wire::Hello& hello) {
  return "reports another id there: \"" + std::string(hello.id) + '"';
}

std::int64_t now_ns() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(
             std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

void Arrivals::take(std::string_view topic, const std::uint8_t* message, std::size_t size,
                    bool retained) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (size > 0 && places_.count(topic) == 0 && !id_in(topic).empty()) {
    newcomers_.push_back(add(id_in(topic)));
  }
  const auto found = places_.find(topic);
  if (found == places_.end() ||
      (outlets_[found->second.outlet].faulty &&
       !(found->second.hello &&
         is_looked_at_again(found->second.outlet, message, size, retained)))) {
    return;
  }
  if (found->second.hello) {
    take_hello(found->second.outlet, message, size, retained);
  } else if (Outlet& outlet = outlets_[found->second.outlet]; !outlet.joined) {
    outlet.here = outlet.here || size > 0;
  } else if (size > 0) {
    if (const auto read = outlet.stream.take(message, size)) {
      happenings_.messages.push_back({outlet.id, *read, now_ns(), outlet.stream.sequence()});
    }
    ask_if_wanted(found->second.outlet);
  }
}

// Whether this message on the hello topic of an excluded outlet is to be taken: the outlet has
// left, and another, or the same one, is there now; or after a hello with a fault, the outlet has
// started again, perhaps with other firmware.
bool Arrivals::is_looked_at_again(std::size_t place, const std::uint8_t* message, std::size_t size,
                                  bool retained) {
  Outlet& outlet = outlets_[place];
  if (size == 0) {
    leave(place);
    return false;
  }
  if (retained || outlet.takes_turns) {
    return false;
  }
  if (outlet.here) {
    gs::wire::Uplink read;
    std::uint32_t sequence = 0;
    if (!outlet.faulty_hello ||
        gs::wire::decode(message, size, read, sequence) != gs::wire::Decoded::kOk ||
        read.kind != gs::wire::UplinkKind::kHello) {
      return false;
    }
    const bool other_version = read.hello.protocol_version != outlet.hello.protocol_version;
    const bool other_start =
        read.start_number != outlet.start_number && !outlet.turns.knows(read.start_number);
    if (!other_version && !other_start) {
      return false;
    }
    outlet.here = false;
  }
  outlet.faulty = false;
  outlet.stream.expect_a_gap();  // what it has sent meanwhile was not taken
  return true;
}

// Another unit with this id may still be there: it is asked for its hello, which the broker no
// longer has.
void Arrivals::leave(std::size_t place) {
  Outlet& outlet = outlets_[place];
  if (outlet.joined && outlet.here && !outlet.takes_turns) {
    happenings_.changes.emplace_back(Fault{outlet.id, "left the broker"});
  }
  outlet.here = false;
  newcomers_.push_back(place);
}

void Arrivals::ask_if_wanted(std::size_t place) {
  if (outlets_[place].stream.take_wants_identify()) {
    newcomers_.push_back(place);
  }
}

std::size_t Arrivals::add(std::string_view id) {
  Outlet& outlet = outlets_.emplace_back();
  outlet.id = id;
  outlet.hello_topic = topic(outlet.id, kHello);
  outlet.up_topic = topic(outlet.id, kUp);
  places_[outlet.hello_topic] = {outlets_.size() - 1, true};
  places_[outlet.up_topic] = {outlets_.size() - 1, false};
  return outlets_.size() - 1;
}

void Arrivals::expect(const std::vector<std::string>& ids) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const std::string& id : ids) {
    if (places_.count(topic(id, kHello)) == 0) {
      newcomers_.push_back(add(id));
      outlets_.back().here = false;
    }
  }
}

void Arrivals::take_hello(std::size_t place, const std::uint8_t* message, std::size_t size,
                          bool retained) {
  Outlet& outlet = outlets_[place];
  if (size == 0) {
    leave(place);
    return;
  }
  gs::wire::Uplink read;
  std::uint32_t sequence = 0;
  const gs::wire::Decoded decoded = gs::wire::decode(message, size, read, sequence);
  // A retained hello does not prove that the outlet answers, but that one that had left is back.
  if (retained && (!outlet.joined || outlet.here)) {
    outlet.here = true;
    newcomers_.push_back(place);
    if (decoded == gs::wire::Decoded::kMalformed) {
      outlet.stream.take(message, size);  // which keeps the reason
    }
    return;
  }
  const bool is_hello =
      decoded == gs::wire::Decoded::kOk && read.kind == gs::wire::UplinkKind::kHello;
  const bool joins = is_hello && !(outlet.joined && outlet.here);
  if (is_hello && !take_identity(outlet, read, sequence)) {
    return;
  }
  outlet.here = outlet.here || is_hello || !outlet.joined;
  if (const auto taken = outlet.stream.take(message, size); taken && !joins) {
    happenings_.messages.push_back({outlet.id, *taken, now_ns(), outlet.stream.sequence()});
  }
  ask_if_wanted(place);
}

// Runs before the sequence number is checked, because that of another outlet has no meaning here.
// False if the outlet is faulty.
bool Arrivals::take_identity(Outlet& outlet, const gs::wire::Uplink& message,
                             std::uint32_t sequence) {
  const gs::wire::Hello& hello = message.hello;
  if (outlet.joined && hello.id != outlet.id) {
    exclude(outlet, reports_id(hello));
    set_hello(outlet, message, true);
    return false;
  }
  // Of another protocol version, neither the start number nor the instance is known.
  const std::string other_version = protocol_fault(hello);
  outlet.here = outlet.here && other_version.empty();
  // Another unit may take the place of one that has left.
  if (outlet.joined && outlet.here && hello.instance != outlet.hello.instance) {
    exclude(outlet, kSameId + ("instances " + instance_text(outlet.hello.instance)) + " and " +
                        instance_text(hello.instance));
    return false;
  }
  if (outlet.joined && other_version.empty() && hello.instance != outlet.hello.instance) {
    outlet.turns = Turns();
  }
  outlet.takes_turns =
      other_version.empty() && outlet.turns.take(message.start_number, sequence, !outlet.here);
  if (outlet.takes_turns) {
    exclude(outlet, kSameId + ("both have instance " + instance_text(hello.instance)) +
                        ", and each ends the other's connection to the broker");
    return false;
  }
  if (!outlet.joined) {
    outlet.stream.take_faults();  // drops faults from before the outlet was known
  }
  if (!outlet.joined || !outlet.here) {
    const std::string fault = hello.id != outlet.id ? reports_id(hello) : other_version;
    outlet.joined = true;
    set_hello(outlet, message, !fault.empty());
    happenings_.changes.emplace_back(OutletPresence{
        outlet.id, "", hello, fault, message.start_number, message.sample, now_ns()});
  }
  return !outlet.faulty;
}

void Arrivals::set_hello(Outlet& outlet, const gs::wire::Uplink& message, bool faulty) {
  outlet.here = true;
  outlet.hello = message.hello;
  outlet.start_number = message.start_number;
  outlet.faulty = faulty;
  outlet.faulty_hello = faulty;
}

void Arrivals::exclude(Outlet& outlet, const std::string& fault) {
  outlet.faulty = true;
  outlet.faulty_hello = false;
  happenings_.changes.emplace_back(Fault{outlet.id, fault, "", true});
}

std::vector<std::size_t> Arrivals::take_newcomers() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::sort(newcomers_.begin(), newcomers_.end());
  newcomers_.erase(std::unique(newcomers_.begin(), newcomers_.end()), newcomers_.end());
  return std::exchange(newcomers_, {});
}

const std::string& Arrivals::id(std::size_t outlet) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return outlets_[outlet].id;
}

std::optional<std::size_t> Arrivals::find(const std::string& id) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = places_.find(topic(id, kHello));
  return found != places_.end() && outlets_[found->second.outlet].joined
             ? std::optional(found->second.outlet)
             : std::nullopt;
}

std::vector<std::uint8_t> Arrivals::encode(std::size_t outlet, const gs::wire::Downlink& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Outlet& wanted = outlets_[outlet];
  const bool seeks_another = message.kind == gs::wire::DownlinkKind::kIdentify && !wanted.here;
  if (wanted.takes_turns || (wanted.faulty && !seeks_another)) {
    return {};
  }
  if (!wanted.here && !seeks_another) {
    wanted.stream.note("was not sent a message: it is not on the broker");
    return {};
  }
  return wanted.stream.encode(message);
}

void Arrivals::note(std::size_t outlet, const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  outlets_[outlet].stream.note(fault);
}

void Arrivals::note_all(const std::string& fault) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Outlet& outlet : outlets_) {
    if (outlet.joined) {
      outlet.stream.note(fault);
    }
  }
}

void Arrivals::hand_over(Happenings& happenings) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (happenings.messages.empty()) {
    happenings.messages.swap(happenings_.messages);
  }
  happenings.append(happenings_);
  happenings_.clear();
  for (Outlet& outlet : outlets_) {
    for (std::string& fault : outlet.stream.take_faults()) {
      if (outlet.joined && !outlet.faulty) {
        happenings.faults.push_back({outlet.id, std::move(fault)});
      }
    }
  }
}

std::vector<Fault> Arrivals::missing(const std::vector<std::string>& wanted) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<Fault> all;
  for (const std::string& id : wanted) {
    const auto found = places_.find(topic(id, kHello));
    if (found == places_.end() || !outlets_[found->second.outlet].here) {
      all.push_back({id, "is not on the broker"});
    }
  }
  for (const Outlet& outlet : outlets_) {
    if (outlet.here && !outlet.joined) {
      const std::string& unreadable = outlet.stream.unreadable();
      all.push_back({outlet.id, unreadable.empty() ? "does not answer" : unreadable});
    }
  }
  return all;
}

}  // namespace gsbench::link
