// Outlets that send frames (wire/frame.hpp), each over its own transport: a serial port or TCP. A
// thread of the link receives bytes and stamps each message's arrival. An unplugged port is
// reported apart from a silent outlet; the link tries to reopen it every 250 ms.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <transport/transport.hpp>

namespace gsbench::link {

struct FramedOptions {
  std::vector<std::string> ports;  // port names for transport::make_transport()
  int baud = transport::kBaud;
  // If a port cannot be opened: true, for discovery, skips the port; with false, open() returns an
  // error.
  bool skip_unusable = false;
};

class FramedLink final : public Link {
 public:
  explicit FramedLink(FramedOptions options);
  ~FramedLink() override;

  // Opens all ports. Then the thread sends `identify` on each port every 500 ms until an outlet
  // answers.
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
