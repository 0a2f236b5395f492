// Two outlets on cables and a link to them.
#pragma once

#include <link_framed/framed_link.hpp>
#include <link_test/emulated_outlets.hpp>
#include <link_test/link_fixture.hpp>

#include <gmock/gmock.h>

#include <emulation/null_modem.hpp>

namespace gsbench::test {

class OutletsOnCables : public LinkFixture {
 protected:
  emulation::NullModem& cable(const std::string& id) {
    return outlets_.hardware().cable(outlets_.place(id));
  }
  std::string port(const std::string& id) const {
    return outlets_.hardware().serial_ports()[outlets_.place(id)];
  }

  link::FramedOptions options() const {
    link::FramedOptions options;
    options.ports = outlets_.hardware().serial_ports();
    return options;
  }
  // Waits for an outlet on each port.
  void open() { open(options()); }
  void open(const link::FramedOptions& options) {
    LinkFixture::open(std::make_shared<link::FramedLink>(options), options.ports, kPatience);
  }

  static constexpr auto kPatience = std::chrono::seconds(3);
  EmulatedOutlets outlets_{{kA, kB}, emulation::Connection::kSerial};
};

}  // namespace gsbench::test
