// What a broker delivers, sorted by outlet, between the thread that receives it and the bench.
#pragma once

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
  // ---- from the thread that receives

  // `retained`: the broker had kept it, nobody says it now.
  void take(std::string_view topic, const std::uint8_t* message, std::size_t size, bool retained);
  void note_all(const std::string& fault);

  // ---- from the bench, and of an outlet by its place in the order of their first hellos

  // Those of which the broker had kept a hello: they are to be asked who they are.
  std::vector<std::size_t> take_newcomers();
  const std::string& id(std::size_t outlet);
  std::optional<std::size_t> find(const std::string& id);  // among those that joined
  // Nothing for an outlet that is at fault, nor for one that has left the broker: that is a fault.
  std::vector<std::uint8_t> encode(std::size_t outlet, const gs::wire::Downlink& message);
  void note(std::size_t outlet, const std::string& fault);
  // Of joined outlets, all but the broker's name.
  void hand_over(Happenings& happenings);
  // Those of `wanted` that the broker does not know, and all that do not answer.
  std::vector<Fault> missing(const std::vector<std::string>& wanted);

 private:
  struct Outlet {
    std::string id;
    std::string hello_topic;
    std::string up_topic;
    OutletStream stream{Delivery::kByBroker};
    bool here = true;  // as far as the broker has told
    bool joined = false;
    gs::wire::Hello hello;                 // by which it joined
    std::vector<std::uint8_t> last_hello;  // as it came
    bool at_fault = false;                 // excluded from the run
  };
  struct Place {
    std::size_t outlet = 0;
    bool hello = false;
  };

  void add(std::string_view hello_topic);
  void take_hello(std::size_t place, const std::uint8_t* message, std::size_t size, bool retained);
  bool take_identity(Outlet& outlet, const gs::wire::Hello& hello);

  std::mutex mutex_;
  std::deque<Outlet> outlets_;  // their topics are the keys below
  std::unordered_map<std::string_view, Place> places_;
  std::vector<std::size_t> newcomers_;
  Happenings happenings_;  // but for the faults, which their streams keep
};

}  // namespace gsbench::link
