// Adapters for the suites: a link to outlets "a" and "b". A new link gets the tests by an adapter
// and a line in a table below.
#pragma once

#include <link_test/emulated_outlets.hpp>
#include <link_test/link_fixture.hpp>

#include <memory>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

namespace gsbench::test {

class LinkRig {
 public:
  virtual ~LinkRig() = default;
  // A link to both outlets, not open.
  virtual std::shared_ptr<link::Link> make_link() = 0;
  // Plays for at least `reports` measurements of each outlet, 16 ms each, at zero voltage.
  virtual void play(int reports) = 0;
};

// Outlets that are processes and can be lost.
class ProcessRig : public LinkRig {
 public:
  explicit ProcessRig(emulation::Connection connection) : outlets({kA, kB}, connection) {}

  void play(int reports) override { outlets.play(reports); }

  // Disconnects outlet a: its cable, or the outlet itself if it has no cable of its own.
  virtual void unplug() = 0;
  virtual void plug_in() = 0;

  // The fault reported for an outlet that …
  struct FaultTexts {
    std::string absent;         // … is absent when the link is opened
    std::string lost;           // … is lost while the link is open
    std::string undeliverable;  // … is sent a message while lost
  };
  virtual FaultTexts fault_texts() const = 0;

  EmulatedOutlets outlets;
};

// All except the first return a ProcessRig.
std::unique_ptr<LinkRig> simulated_rig();
std::unique_ptr<LinkRig> tcp_rig();
std::unique_ptr<LinkRig> serial_rig();
std::unique_ptr<LinkRig> mqtt_rig();

struct LinkUnderTest {
  const char* name;
  std::unique_ptr<LinkRig> (*make)();
};

inline void PrintTo(const LinkUnderTest& link, std::ostream* out) {
  *out << link.name;
}

constexpr LinkUnderTest kInProcess[] = {{"Simulated", simulated_rig}};
constexpr LinkUnderTest kToProcesses[] = {
    {"FramedOverTcp", tcp_rig}, {"FramedOverSerial", serial_rig}, {"Mqtt", mqtt_rig}};

inline std::string name_of(const testing::TestParamInfo<LinkUnderTest>& link) {
  return link.param.name;
}

}  // namespace gsbench::test
