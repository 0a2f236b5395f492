// Messages between the bench and its outlets, whatever carries them. Outlets are known by the id
// that they say of themselves; they join and leave while a link is open.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <wire/messages.hpp>

namespace gsbench::link {

// An outlet that said who it is. A faulty outlet is excluded: it is
// sent nothing and what it says is passed over, so that no other outlet suffers from it.
struct OutletPresence {
  std::string id;
  std::string where;  // "simulated", "/dev/ttyUSB0", "mqtts://127.0.0.1:8883"
  gs::wire::Hello hello;
  std::string fault = {};  // as in Fault; empty: none
};

// What a link found wrong with one outlet. The others go on.
struct Fault {
  std::string id;
  std::string what;  // one sentence, for people
};

struct Received {
  std::string id;
  gs::wire::Uplink message;
  std::int64_t arrival_ns = 0;  // std::chrono::steady_clock; 0: of no meaning, as in simulation
};

// Each once, and each kind in the order of time for each outlet.
struct Happenings {
  std::vector<OutletPresence> joined;
  std::vector<Fault> left;  // and how; from now on one cannot speak with them
  std::vector<Received> messages;
  std::vector<Fault> faults;

  void append(const Happenings& more) {
    joined.insert(joined.end(), more.joined.begin(), more.joined.end());
    left.insert(left.end(), more.left.begin(), more.left.end());
    messages.insert(messages.end(), more.messages.begin(), more.messages.end());
    faults.insert(faults.end(), more.faults.begin(), more.faults.end());
  }
  // Keeps the memory: it is filled again at each poll.
  void clear() {
    joined.clear();
    left.clear();
    messages.clear();
    faults.clear();
  }
};

// An error is one of the link as a whole.
class Link {
 public:
  virtual ~Link() = default;
  // Starts to look for outlets, and does not wait for them: they join (wait_for_outlets.hpp).
  [[nodiscard]] virtual drivers::Status open() = 0;
  // To an outlet that joined, else an error. Does not wait for an answer. An outlet that cannot be
  // reached now is a Fault.
  [[nodiscard]] virtual drivers::Status send(const std::string& id,
                                             const gs::wire::Downlink& message) = 0;
  // Appends what happened since the last call.
  [[nodiscard]] virtual drivers::Status poll(Happenings& happenings) = 0;
  // Of those that it was told to look for, or has seen a trace of, and that have not joined: why,
  // as far as it can tell.
  virtual std::vector<Fault> missing() { return {}; }
  virtual void close() noexcept = 0;
};

}  // namespace gsbench::link
