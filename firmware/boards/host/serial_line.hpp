// A line over a serial port or a pseudo-terminal: 921 600 Bd, 8N1, no flow control.
#pragma once

#include "descriptor_line.hpp"

#include <string>
#include <utility>

namespace gs::host {

class SerialLine final : public DescriptorLine {
 public:
  explicit SerialLine(std::string device) : device_(std::move(device)) {}  // "/dev/ttyUSB0"

 private:
  int connect(std::string& far_end, std::string& why) override;

  std::string device_;
};

}  // namespace gs::host
