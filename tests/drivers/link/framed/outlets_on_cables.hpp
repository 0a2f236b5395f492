// Two outlets on cables and a link to them.
#pragma once

#include <link_framed/framed_link.hpp>
#include <link_test/emulated_outlets.hpp>
#include <link_test/hears_a_link.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <emulation/null_modem.hpp>

namespace gsbench::test {

class OutletsOnCables : public HearsALink {
 protected:
  emulation::NullModem& cable(std::size_t outlet) { return outlets_.hardware().cable(outlet); }
  std::string port(std::size_t outlet) const { return outlets_.hardware().serial_ports()[outlet]; }

  link::FramedOptions options() const {
    link::FramedOptions options;
    options.ports = outlets_.hardware().serial_ports();
    return options;
  }
  void open() { open(options()); }
  void open(const link::FramedOptions& options) {
    HearsALink::open(std::make_shared<link::FramedLink>(options));
  }

  EmulatedOutlets outlets_{{"a", "b"}, emulation::Connection::kSerial};
};

}  // namespace gsbench::test
