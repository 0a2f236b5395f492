// The bench's end of one outlet's messages. It decodes them, drops duplicates, and notes faults
// (lost messages, damaged messages, restarts of the outlet).
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

// How a link may disturb the order of messages. On a cable, a message may arrive twice, or after
// the one that follows it. A broker may send all unacknowledged messages again.
enum class Delivery : std::uint8_t { kByCable, kByBroker };

class OutletStream {
 public:
  explicit OutletStream(Delivery delivery) : delivery_(delivery) {}

  // Takes one whole message. Returns nothing for a duplicate. Returns nothing for an unreadable
  // message either, and notes a fault. A restarted outlet sends a hello unasked. If that hello is
  // lost, the restart shows in sequence and sample numbers that go back.
  std::optional<gs::wire::Uplink> take(const std::uint8_t* message, std::size_t size);

  // Notes any other fault of this outlet, such as a frame with a wrong CRC.
  void note(const std::string& fault) { faults_.push_back(fault); }
  std::vector<std::string> take_faults() { return std::exchange(faults_, {}); }

  // The next message to the outlet, as bytes. `identify` restarts the numbering.
  std::vector<std::uint8_t> encode(const gs::wire::Downlink& message);

 private:
  void note_restart() { note("restarted after its sample " + std::to_string(last_sample_)); }

  Delivery delivery_;
  gs::wire::Sequence received_;
  std::uint32_t sent_ = 0;
  bool hello_received_ = false;
  bool reports_received_ = false;  // any message but hellos
  std::uint64_t last_sample_ = 0;
  std::vector<std::uint8_t> newest_;  // bytes of the newest message if it is a hello with number 0
  std::vector<std::string> faults_;
};

}  // namespace gsbench::link
