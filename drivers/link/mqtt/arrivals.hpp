// What a broker delivers, sorted by outlet, between the thread that receives it and the bench.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <link/link.hpp>
#include <link/outlet_stream.hpp>

namespace gsbench::link {

std::string hello_topic(const std::string& id);
std::string up_topic(const std::string& id);
std::string down_topic(const std::string& id);

class Arrivals {
 public:
  using Deadline = std::chrono::steady_clock::time_point;

  // ---- from the thread that receives

  // `retained`: the broker had kept it, nobody says it now.
  void take(std::string_view topic, const std::uint8_t* message, std::size_t size, bool retained);
  void note_all(const std::string& fault);

  // ---- from the bench

  // Ids of outlets that have a hello on the broker: once all the wanted ones have, or at `until`.
  std::vector<std::string> wait_for_hellos(const std::vector<std::string>& wanted, Deadline until);
  // From now on, places are those in `ids`, and what they say counts from their next hello on.
  void expect(const std::vector<std::string>& ids);
  // Until each has said hello, and some time for a second one of the same id; or until `until`.
  void wait_for_answers(Deadline until);
  // One of them is at fault, which is known without asking it.
  void leave_out(std::size_t outlet, const std::string& fault);
  // Ends the opening: each outlet with its hello, or what is wrong with it, where it is all but the
  // broker's name.
  std::vector<OutletPresence> settle();

  // Nothing for an outlet that is at fault, nor for one that has left the broker: that is a fault.
  std::vector<std::uint8_t> encode(std::size_t outlet, const gs::wire::Downlink& message);
  void note(std::size_t outlet, const std::string& fault);
  void hand_over(std::vector<Received>& messages, std::vector<Fault>& faults);

 private:
  struct Outlet {
    std::string id;
    std::string hello_topic;
    std::string up_topic;
    OutletStream stream{Delivery::kByBroker};
    bool here = true;  // as far as the broker has told
    bool said_hello = false;
    gs::wire::Hello hello;                 // the first one
    std::vector<std::uint8_t> last_hello;  // as it came
    std::string trouble;                   // while opening: why it is at fault
    bool left_out = false;                 // it is at fault: nobody speaks with it
  };
  struct Place {
    std::size_t outlet = 0;
    bool hello = false;
  };

  void take_candidate(std::string_view topic, std::size_t size);
  void take_hello(std::size_t place, const std::uint8_t* message, std::size_t size, bool retained);
  bool take_identity(Outlet& outlet, const gs::wire::Hello& hello);
  void take_message(std::size_t place, const std::uint8_t* message, std::size_t size);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, bool> candidates_;  // by id: has a hello on the broker
  std::deque<Outlet> outlets_;              // their topics are the keys below
  std::unordered_map<std::string_view, Place> places_;
  std::size_t silent_ = 0;  // outlets that have not said hello
  std::vector<Received> received_;
};

}  // namespace gsbench::link
