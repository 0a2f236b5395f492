// The bench's end of one outlet's messages: decoded, in order, each once; what is missing or
// damaged is reported as a fault, and so is a restart of the outlet.
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

// What a link may do to messages: on a cable one may come twice or behind the next, a broker may
// bring all again that have not been acknowledged.
enum class Delivery : std::uint8_t { kByCable, kByBroker };

class OutletStream {
 public:
  explicit OutletStream(Delivery delivery) : delivery_(delivery) {}

  // One whole message. Nothing for a duplicate, and where it cannot be read: then a fault is noted.
  // An outlet that restarts says hello unasked; where that was lost, its numbers and samples show
  // it.
  std::optional<gs::wire::Uplink> take(const std::uint8_t* message, std::size_t size);

  // Any other fault of this outlet's, such as a frame with a wrong CRC.
  void note(const std::string& fault) { faults_.push_back(fault); }
  std::vector<std::string> take_faults() { return std::exchange(faults_, {}); }

  // The next message to it, as bytes. Identifying restarts the numbering.
  std::vector<std::uint8_t> encode(const gs::wire::Downlink& message);

 private:
  void note_restart() { note("restarted after its sample " + std::to_string(last_sample_)); }

  Delivery delivery_;
  gs::wire::Sequence received_;
  std::uint32_t sent_ = 0;
  bool said_hello_ = false;
  std::uint64_t last_sample_ = 0;
  std::vector<std::uint8_t> newest_;  // where it was a first hello, its bytes
  std::vector<std::string> faults_;
};

}  // namespace gsbench::link
