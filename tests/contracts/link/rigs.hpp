// What the suites need of a link: outlets "a" and "b" that it leads to. A new link gets their tests
// by an adapter and a line in the table of a suite.
#pragma once

#include <link_test/emulated_outlets.hpp>

#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <link/link.hpp>

namespace gsbench::test {

constexpr std::size_t kA = 0;
constexpr std::size_t kB = 1;

class LinkRig {
 public:
  virtual ~LinkRig() = default;
  // To both outlets, in their order; not open yet.
  virtual std::shared_ptr<link::Link> make_link() = 0;
  // So many measurements of each outlet, of 16 ms and without a voltage, or some more.
  virtual void play(int reports) = 0;
};

// Outlets that are processes, and can be lost.
class ProcessRig : public LinkRig {
 public:
  explicit ProcessRig(emulation::Connection connection) : outlets({"a", "b"}, connection) {}

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

std::unique_ptr<LinkRig> simulated_rig();
std::unique_ptr<ProcessRig> tcp_rig();
std::unique_ptr<ProcessRig> serial_rig();
std::unique_ptr<ProcessRig> mqtt_rig();

// A row of a suite's table.
template <class R>
struct Row {
  const char* name;
  std::unique_ptr<R> (*make)();
};

template <class R>
std::string name_of(const testing::TestParamInfo<Row<R>>& row) {
  return row.param.name;
}

}  // namespace gsbench::test
