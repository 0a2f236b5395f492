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
  int baud = transport::kBaud;
  // For looking what is there: a port that cannot be opened is left out, else it is an error.
  bool skip_unusable = false;
};

class FramedLink final : public Link {
 public:
  explicit FramedLink(FramedOptions options);
  ~FramedLink() override;

  // Asks on every port who is there, again and again until an outlet says so.
  [[nodiscard]] drivers::Status open() override;
  [[nodiscard]] drivers::Status send(const std::string& id,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(Happenings& happenings) override;
  void close() noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::link
