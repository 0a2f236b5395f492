// One serial port through libserialport. Nothing blocks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <drivers/result.hpp>

struct sp_port;

namespace gsbench::link {

class Port {
 public:
  Port(std::string path, int baud) : path_(std::move(path)), baud_(baud) {}
  ~Port() { close(); }
  Port(const Port&) = delete;
  Port& operator=(const Port&) = delete;

  const std::string& path() const { return path_; }
  // Raw, 8N1; forgets what had come before.
  drivers::Status open();
  bool is_open() const { return port_ != nullptr; }
  int descriptor() const { return descriptor_; }
  void close() noexcept;

  // Appends what is there; false where the port is gone.
  bool read(std::vector<std::uint8_t>& bytes);
  // All of them, or false: the port is gone, or takes nothing for a tenth of a second.
  bool write(const std::vector<std::uint8_t>& bytes);

 private:
  drivers::Status configure();
  drivers::Error failure(const std::string& doing) const;

  std::string path_;
  int baud_;
  sp_port* port_ = nullptr;
  int descriptor_ = -1;
};

}  // namespace gsbench::link
