// The bench's end of one outlet's messages, on any link. It decodes them, drops late messages and
// duplicates, and notes faults (lost messages, damaged messages, restarts of the outlet). It
// follows wire/README.md, "Starts and sessions" and "Numbering".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <wire/codec.hpp>
#include <wire/frame.hpp>

namespace gsbench::link {

// What is known of an outlet that sends messages of a new start before its hello. On a cable it may
// be another outlet. On a broker's topic it is the same one.
enum class Delivery : std::uint8_t { kByCable, kByBroker };

// A random number for a link's `identify` and all that follows it. Never 0.
std::uint32_t new_session();

class OutletStream {
 public:
  explicit OutletStream(Delivery delivery, std::uint32_t session = new_session())
      : delivery_(delivery), session_(session) {}

  // Takes one whole message. Returns nothing for a late message, a duplicate, and an unreadable
  // message; the last is noted as a fault. A message of another start than the last one is a
  // restart, whatever its kind.
  std::optional<gs::wire::Uplink> take(const std::uint8_t* message, std::size_t size);
  // Of the message that take() returned last.
  std::uint32_t sequence() const { return sequence_; }
  // Why the newest message could not be read, of those since the newest hello; empty: all could.
  const std::string& unreadable() const { return unreadable_; }

  // True once after each message that must be answered by `identify` at once: the outlet has
  // restarted, or does not know this session. On a cable, once for each start; the link repeats it
  // until is_open().
  bool take_wants_identify() { return std::exchange(wants_identify_, false); }
  // Whether the newest start of the outlet has answered `identify`.
  bool is_open() const { return open_; }

  // Messages before the next one do not count as lost: they were not given to take().
  void expect_a_gap() { others_.restart(); }

  // Notes any other fault of this outlet, such as a frame with a wrong CRC.
  void note(const std::string& fault) { faults_.push_back(fault); }
  std::vector<std::string> take_faults() { return std::exchange(faults_, {}); }

  // The next message to the outlet, as bytes.
  std::vector<std::uint8_t> encode(gs::wire::Downlink message);

 private:
  bool take_start(const gs::wire::Uplink& message);
  bool take_number(const gs::wire::Uplink& message, std::uint32_t sequence);
  void look_at_session(const gs::wire::Uplink& message);
  void begin_start(std::uint32_t number);
  void want_identify(std::uint32_t start);

  Delivery delivery_;
  std::uint32_t session_;
  std::optional<std::uint32_t> start_;             // the newest
  std::optional<std::uint32_t> identified_start_;  // the newest for which `identify` was wanted
  std::vector<std::uint32_t> earlier_starts_;
  std::string id_;  // of the newest hello
  gs::wire::Sequence hellos_;
  gs::wire::Sequence others_;
  std::uint32_t sent_ = 0;
  bool wants_identify_ = false;
  bool open_ = false;
  std::uint64_t instance_ = 0;
  std::uint64_t last_sample_ = 0;
  std::uint32_t sequence_ = 0;
  std::string unreadable_;
  std::vector<std::string> faults_;
};

}  // namespace gsbench::link
