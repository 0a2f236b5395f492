// Messages between the bench and its outlets, whatever carries them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <wire/messages.hpp>

namespace gsbench::link {

struct OutletPresence {
  std::string id;
  gs::wire::Hello hello;
};

struct Received {
  std::size_t outlet = 0;  // place in what open() returned
  std::int64_t tick = 0;   // the outlet's stamp on the bench's time base
  gs::wire::Uplink message;
};

class Link {
 public:
  virtual ~Link() = default;
  virtual std::string name() const = 0;  // "simulated", "serial", "mqtt"

  // Finds the outlets; those that answered, in a fixed order.
  [[nodiscard]] virtual drivers::Result<std::vector<OutletPresence>> open() = 0;
  [[nodiscard]] virtual drivers::Status send(std::size_t outlet,
                                             const gs::wire::Downlink& message) = 0;
  // Appends what came since the last call, in order of arrival for each outlet.
  [[nodiscard]] virtual drivers::Status poll(std::vector<Received>& messages) = 0;
  virtual void close() noexcept = 0;
};

}  // namespace gsbench::link
