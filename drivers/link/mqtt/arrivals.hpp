// Messages from the broker, sorted by outlet. Shared by Paho's receiving thread and the bench's
// thread; every call takes a lock.
#pragma once

#include "turns.hpp"

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <link/link.hpp>
#include <link/outlet_stream.hpp>

namespace gsbench::link {

constexpr const char* kHello = "hello";
constexpr const char* kUp = "up";
constexpr const char* kDown = "down";
inline std::string topic(const std::string& id, const char* what) {
  return "gs/" + id + '/' + what;
}

class Arrivals {
 public:
  // ---- called by the receiving thread

  // `retained`: a message that the broker had stored, not one just sent.
  void take(std::string_view topic, const std::uint8_t* message, std::size_t size, bool retained);
  void note_all(const std::string& fault);

  // ---- called by the bench; outlets are numbered from 0 in the order of their first hellos

  // Call once, after the subscription: outlets that are wanted. Those of which nothing has arrived
  // are newcomers: they may be there although the broker has no hello of theirs.
  void expect(const std::vector<std::string>& ids);
  // Outlets to which the bench must send `identify`, each once: because they were heard for the
  // first time, their hello was retained, they have not begun the bench's session, or a unit with
  // their id has left.
  std::vector<std::size_t> take_newcomers();
  const std::string& id(std::size_t outlet);
  std::optional<std::size_t> find(const std::string& id);  // among those that joined
  // The message to the outlet, as bytes. Empty if the outlet is faulty. Empty also if the outlet
  // has left the broker; this is noted as a fault. `identify` may be sent to one that has left.
  std::vector<std::uint8_t> encode(std::size_t outlet, const gs::wire::Downlink& message);
  void note(std::size_t outlet, const std::string& fault);
  // Appends what happened since the last call. The places are left empty.
  void hand_over(Happenings& happenings);
  // Outlets of `wanted` that are not on the broker, and all outlets on the broker that do not
  // answer.
  std::vector<Fault> missing(const std::vector<std::string>& wanted);

 private:
  struct Outlet {
    std::string id;
    std::string hello_topic;
    std::string up_topic;
    OutletStream stream{Delivery::kByBroker};
    bool here = true;  // connected to the broker, according to its newest hello
    bool joined = false;
    gs::wire::Hello hello;           // with which it joined, or for which it was excluded
    std::uint32_t start_number = 0;  // of this hello
    bool faulty = false;             // excluded from the run
    bool faulty_hello = false;       // excluded for this hello, and not because there are two units
    // Two units take turns, each with the client id of the other: faulty until the link is closed.
    bool takes_turns = false;
    Turns turns;
  };
  struct Place {
    std::size_t outlet = 0;
    bool hello = false;
  };

  std::size_t add(std::string_view id);
  void take_hello(std::size_t place, const std::uint8_t* message, std::size_t size, bool retained);
  bool is_looked_at_again(std::size_t place, const std::uint8_t* message, std::size_t size,
                          bool retained);
  void leave(std::size_t place);
  void ask_if_wanted(std::size_t place);
  bool take_identity(Outlet& outlet, const gs::wire::Uplink& message, std::uint32_t sequence);
  static void set_hello(Outlet& outlet, const gs::wire::Uplink& message, bool faulty);
  void exclude(Outlet& outlet, const std::string& fault);

  std::mutex mutex_;
  std::deque<Outlet> outlets_;  // own the topics that are the keys of places_
  std::unordered_map<std::string_view, Place> places_;
  std::vector<std::size_t> newcomers_;
  Happenings happenings_;  // except faults: each outlet's stream keeps them
};

}  // namespace gsbench::link
