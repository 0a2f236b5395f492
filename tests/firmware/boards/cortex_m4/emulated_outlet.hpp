// An outlet on an emulated Cortex-M4F, or as a process of this machine, as the bench meets one:
// terminals in shared memory, a doorbell and a link.
#pragma once

#include "machine.hpp"
#include <shared_memory_io/shared_memory.hpp>
#include <test_support/temporary_folder.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <emulation/child.hpp>
#include <wire/frame.hpp>

namespace gs::test {

using Message = std::vector<std::uint8_t>;  // CBOR

struct Letter {
  wire::Uplink uplink;
  std::uint32_t sequence = 0;
  Message bytes;
};

// The test's end of a serial link.
class Line {
 public:
  explicit Line(const Socket& socket) : socket_(socket) {}

  void send(const wire::Downlink& message);
  // Reads what comes until `enough` says so; throws after kPatience.
  void read_until(const std::function<bool()>& enough, const std::string& what);
  void read_for(std::chrono::milliseconds patience);

  const std::vector<Letter>& letters() const { return letters_; }
  std::vector<Letter> of(wire::UplinkKind kind) const;
  // The newest of the kind once it is there, among those from `first` on.
  Letter wait_for(wire::UplinkKind kind, std::size_t first = 0);
  bool has_error(wire::ErrorCode code) const;

 private:
  const Socket& socket_;
  wire::FrameReader reader_;
  std::vector<Letter> letters_;
  std::uint32_t sequence_ = 0;
};

class EmulatedOutlet {
 public:
  EmulatedOutlet();
  ~EmulatedOutlet();
  EmulatedOutlet(const EmulatedOutlet&) = delete;
  EmulatedOutlet& operator=(const EmulatedOutlet&) = delete;

  // Switches it on, with the terminals as they are.
  void start(const std::string& image);
  // gs-outlet, on a line.
  void start_process(const std::string& program);
  void kill();

  // In blocks, never more than half a ring ahead, until all are taken. The link is read meanwhile.
  void play(const std::vector<std::int16_t>& samples);
  void ring_doorbell();

  shared_memory_io::SharedMemory& terminals() { return *terminals_; }
  Line& line() { return *line_; }
  const Machine& machine() const { return *machine_; }

 private:
  gsbench::test::TemporaryFolder folder_;
  shared_memory_io::SharedMemory* terminals_ = nullptr;
  // One of the two.
  std::unique_ptr<Machine> machine_;
  struct Process;
  std::unique_ptr<Process> process_;
  std::unique_ptr<Line> line_;
};

}  // namespace gs::test
