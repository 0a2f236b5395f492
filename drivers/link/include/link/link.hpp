// Messages between the bench and its outlets, whatever carries them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <wire/messages.hpp>

namespace gsbench::link {

// An outlet that was looked for. With one that is at fault nobody speaks, and what it says is
// passed over: no other outlet suffers from it.
struct OutletPresence {
  std::string id;     // its place instead, or both, where that tells nobody apart
  std::string where;  // "simulated", "/dev/ttyUSB0", "mqtts://127.0.0.1:8883"
  gs::wire::Hello hello;
  std::string fault = {};  // as in Fault; empty: none
};

// Outlets that say the same id in their hellos are all at fault, by their places: which of them was
// meant nobody can tell.
void mark_twins(std::vector<OutletPresence>& outlets);

// What a link found wrong with one outlet. The others go on.
struct Fault {
  std::size_t outlet = 0;  // place in what open() returned
  std::string what;        // one sentence, for people
};

struct Received {
  std::size_t outlet = 0;  // place in what open() returned
  gs::wire::Uplink message;
  std::int64_t arrival_ns = 0;  // std::chrono::steady_clock; 0: of no meaning, as in simulation
};

class Link {
 public:
  virtual ~Link() = default;
  virtual std::string name() const = 0;  // "simulated", "serial", "mqtt"

  // Finds the outlets, in a fixed order: those that were named, with a fault where they do not
  // answer, or all that answer where none was. Two that say they are the same are both at fault. An
  // error is one of the link as a whole.
  [[nodiscard]] virtual drivers::Result<std::vector<OutletPresence>> open() = 0;
  // Does not wait for an answer. An outlet that cannot be reached now is a Fault, not an error.
  [[nodiscard]] virtual drivers::Status send(std::size_t outlet,
                                             const gs::wire::Downlink& message) = 0;
  // Appends what came since the last call, in order of arrival for each outlet, each message once.
  // An error is one of the link as a whole.
  [[nodiscard]] virtual drivers::Status poll(std::vector<Received>& messages,
                                             std::vector<Fault>& faults) = 0;
  virtual void close() noexcept = 0;
};

}  // namespace gsbench::link
