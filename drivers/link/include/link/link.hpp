// Messages between the bench and its outlets, independent of what carries them. An outlet is known
// by the id that it reports; outlets join and leave while a link is open. A link is used by one
// thread at a time.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <drivers/result.hpp>
#include <wire/messages.hpp>

namespace gsbench::link {

// An outlet that has sent its hello. If the outlet has another protocol version, or a wrong or
// duplicate id, the link sends nothing to it and ignores its messages, until it may join again
// (wire/README.md, hello). After any other fault, the link continues to exchange messages with the
// outlet.
struct OutletPresence {
  std::string id;
  std::string where;  // "simulated", "/dev/ttyUSB0", "mqtts://127.0.0.1:8883"
  gs::wire::Hello hello;
  std::string fault = {};  // as in Fault; empty: none
  // Of the message with the hello. Of another protocol version, the start number is 0.
  std::uint32_t start_number = 0;
  std::uint64_t sample = 0;
  std::int64_t arrival_ns = 0;  // as in Received
};

// A fault of one outlet; it does not affect the others.
struct Fault {
  std::string id;
  std::string what;        // one sentence, for people
  std::string where = {};  // as in OutletPresence; empty: not known
  // In Happenings::changes: the outlet is still there, but from now on the link ignores it.
  bool excluded = false;
};

// How the fault of two outlets with the same id begins, on any link. What distinguishes them
// follows.
constexpr const char* kSameId = "has the same id as another outlet: ";
// In two places; `where`: the place of the other one.
inline std::string same_id_fault(const std::string& where) {
  return kSameId + ("the one on " + where);
}

struct Received {
  std::string id;
  gs::wire::Uplink message;
  std::int64_t arrival_ns = 0;  // std::chrono::steady_clock; 0: none, as in simulation
  std::uint32_t sequence = 0;
};

// An outlet has joined, or it has left, with the reason: it can no longer be reached. One that has
// joined may join again without having left: its new hello replaces the one before.
using Change = std::variant<OutletPresence, Fault>;

// Each event appears once. In each list, the events of one outlet are in the order of time.
struct Happenings {
  std::vector<Change> changes;
  std::vector<Received> messages;
  std::vector<Fault> faults;

  void append(const Happenings& more) {
    changes.insert(changes.end(), more.changes.begin(), more.changes.end());
    messages.insert(messages.end(), more.messages.begin(), more.messages.end());
    faults.insert(faults.end(), more.faults.begin(), more.faults.end());
  }
  // Keeps the allocated memory for the next poll.
  void clear() {
    changes.clear();
    messages.clear();
    faults.clear();
  }
};

// An error concerns the link as a whole; a problem of one outlet is a Fault.
class Link {
 public:
  virtual ~Link() = default;
  // Starts to look for outlets and does not wait for them to join (see wait_for_outlets.hpp).
  [[nodiscard]] virtual drivers::Status open() = 0;
  // An error if no outlet of this id has joined. Does not wait for an answer. If the outlet cannot
  // be reached now, the next poll() has a Fault.
  [[nodiscard]] virtual drivers::Status send(const std::string& id,
                                             const gs::wire::Downlink& message) = 0;
  // Appends what happened since the last call. Does not wait for messages.
  [[nodiscard]] virtual drivers::Status poll(Happenings& happenings) = 0;
  // Outlets that have not joined, although they were asked for or seen. With the reason if known.
  virtual std::vector<Fault> missing() { return {}; }
  // Outlets whose own port cannot be opened now, by place, with the reason. The others are not
  // affected. An open link goes on trying, and such an outlet may join later.
  virtual std::vector<Fault> unreachable() { return {}; }
  virtual void close() noexcept = 0;
};

}  // namespace gsbench::link
