// A TCP connection: to an emulated outlet, or a device server.
#pragma once

#include <drivers/descriptor.hpp>
#include <transport/transport.hpp>

namespace gsbench::transport {

bool is_tcp(const std::string& port);
// An error: no "tcp://host:port".
drivers::Status check_address(const std::string& port);

class Tcp final : public Transport {
 public:
  using Transport::Transport;

  drivers::Status open() override;
  void close() noexcept override { socket_.close(); }
  int descriptor() const override { return socket_.get(); }

 private:
  drivers::Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) override;
  drivers::Status read_some(std::vector<std::uint8_t>& bytes) override;

  drivers::Descriptor socket_;
};

}  // namespace gsbench::transport
