// A serial port through libserialport: raw, 8N1, for one program at a time.
#pragma once

#include <transport/transport.hpp>

struct sp_port;

namespace gsbench::transport {

class Serial final : public Transport {
 public:
  Serial(const std::string& port, int baud) : Transport(port), baud_(baud) {}
  ~Serial() override { close(); }

  drivers::Status open() override;
  void close() noexcept override;
  int descriptor() const override { return descriptor_; }

 private:
  drivers::Result<std::size_t> write_some(const std::uint8_t* bytes, std::size_t count) override;
  drivers::Status read_some(std::vector<std::uint8_t>& bytes) override;
  drivers::Status configure();
  drivers::Error last_error(const std::string& doing) const;

  int baud_;
  sp_port* port_ = nullptr;
  int descriptor_ = -1;
};

}  // namespace gsbench::transport
