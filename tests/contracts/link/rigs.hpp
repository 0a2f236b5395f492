// What the suites need of a link: outlets "a" and "b" that it leads to. A new link gets their tests
// by an adapter and a line in a table below.
#pragma once

#include <link_test/emulated_outlets.hpp>
#include <link_test/hears_a_link.hpp>

#include <memory>
#include <string>

#include <gtest/gtest.h>

namespace gsbench::test {

class LinkRig {
 public:
  virtual ~LinkRig() = default;
  // To both outlets; not open yet.
  virtual std::shared_ptr<link::Link> make_link() = 0;
  // So many measurements of each outlet, of 16 ms and without a voltage, or some more.
  virtual void play(int reports) = 0;
};

// Outlets that are processes, and can be lost.
class ProcessRig : public LinkRig {
 public:
  explicit ProcessRig(emulation::Connection connection) : outlets({kA, kB}, connection) {}

  void play(int reports) override { outlets.play(reports); }

  // What connects outlet a, or where nothing of its own does, the outlet itself.
  virtual void unplug() = 0;
  virtual void plug_in() = 0;

  // What is reported of an outlet …
  struct Words {
    std::string absent;         // … that is not there when the link is opened
    std::string lost;           // … that is lost while it is open
    std::string undeliverable;  // … that is sent a message then
    std::string back;           // … that is found again
  };
  virtual Words words() const = 0;

  EmulatedOutlets outlets;
};

// These return a ProcessRig, but for the first.
std::unique_ptr<LinkRig> simulated_rig();
std::unique_ptr<LinkRig> tcp_rig();
std::unique_ptr<LinkRig> serial_rig();
std::unique_ptr<LinkRig> mqtt_rig();

struct LinkUnderTest {
  const char* name;
  std::unique_ptr<LinkRig> (*make)();
};

constexpr LinkUnderTest kInProcess[] = {{"Simulated", simulated_rig}};
constexpr LinkUnderTest kToProcesses[] = {
    {"FramedOverTcp", tcp_rig}, {"FramedOverSerial", serial_rig}, {"Mqtt", mqtt_rig}};

inline std::string name_of(const testing::TestParamInfo<LinkUnderTest>& link) {
  return link.param.name;
}

}  // namespace gsbench::test
