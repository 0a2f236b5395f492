// Outlets that send frames (wire/frame.hpp) over transports of their own: serial ports, TCP. A
// thread waits for bytes and stamps what they bring when it arrives; an outlet that was unplugged
// is distinguished from one that is silent, and is listened to again when its port is back.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <transport/transport.hpp>

namespace gsbench::link {

struct FramedOptions {
  std::vector<std::string> ports;  // as transport::make_transport() takes them
  // Names for ports without an answer, in their order; none: the port itself.
  std::vector<std::string> ids;
  int baud = transport::kBaud;
  double answer_s = 3.0;  // within which each outlet says who it is
  // A port without an outlet is left out instead of at fault: for looking what is there.
  bool skip_silent = false;
};

class FramedLink final : public Link {
 public:
  explicit FramedLink(FramedOptions options);
  ~FramedLink() override;

  std::string name() const override { return "framed"; }
  // A port that cannot be opened is an error, unless it would be left out.
  [[nodiscard]] drivers::Result<std::vector<OutletPresence>> open() override;
  [[nodiscard]] drivers::Status send(std::size_t outlet,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(std::vector<Received>& messages,
                                     std::vector<Fault>& faults) override;
  void close() noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::link
