// Outlets that send frames (wire/frame.hpp), each over its own transport: a serial port or TCP. A
// thread of the link receives bytes and stamps each message's arrival. An unplugged port, and one
// that cannot be opened, is reported apart from a silent outlet; a second thread tries to open it
// every 250 ms.
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
};

class FramedLink final : public Link {
 public:
  explicit FramedLink(FramedOptions options);
  ~FramedLink() override;

  // Tries to open all ports, and does not fail if it cannot: see unreachable(). Blocks for up to
  // 0.5 s for each TCP port. Then the thread sends `identify` on each port every 500 ms until an
  // outlet answers.
  [[nodiscard]] drivers::Status open() override;
  [[nodiscard]] drivers::Status send(const std::string& id,
                                     const gs::wire::Downlink& message) override;
  [[nodiscard]] drivers::Status poll(Happenings& happenings) override;
  // Ports that cannot be opened, and those whose outlet sends only what cannot be read.
  std::vector<Fault> missing() override;
  std::vector<Fault> unreachable() override;
  void close() noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::link
