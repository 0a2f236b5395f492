// An outlet on an emulated Cortex-M4F or as a process of this machine, with the bench's interfaces:
// terminals in shared memory, a doorbell and a link.
#pragma once

#include "machine.hpp"
#include "shared_memory_file.hpp"
#include <test_support/temporary_folder.hpp>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <models/adc.hpp>
#include <wire/frame.hpp>

namespace gs::test {

using Message = std::vector<std::uint8_t>;  // CBOR

struct ReceivedMessage {
  wire::Uplink uplink;
  Message bytes;
};

// The test's end of a serial link.
class Line {
 public:
  explicit Line(gsbench::transport::Transport& transport) : transport_(transport) {}

  // The first message begins the session. Commands are for the start of the newest message.
  void send(wire::Downlink message);
  // Reads messages until `enough` returns true; throws after kPatience.
  void read_until(const std::function<bool()>& enough, const std::string& what);
  void read_for(std::chrono::milliseconds patience);

  const std::vector<ReceivedMessage>& messages() const { return messages_; }
  std::vector<ReceivedMessage> of(wire::UplinkKind kind) const;
  // Waits for the first message of the kind at index `first` or later.
  ReceivedMessage wait_for(wire::UplinkKind kind, std::size_t first = 0);
  bool has_error(wire::ErrorCode code) const;

 private:
  gsbench::transport::Transport& transport_;
  wire::FrameReader reader_;
  std::vector<ReceivedMessage> messages_;
  std::uint32_t sequence_ = 0;
};

class EmulatedOutlet {
 public:
  // Starts it with the current contents of the terminals. `program`: a board's image, or gs-outlet.
  // `options`: more arguments of it, or of qemu.
  void start(const std::string& program, const std::vector<std::string>& options = {});
  void kill() { machine_->kill(); }

  // Plays blocks, at most half a ring ahead, until all are taken. Reads the link meanwhile.
  void play(const std::vector<std::int16_t>& samples);
  void ring_doorbell() { file_.ring(); }

  shared_memory_io::SharedMemory& terminals() const { return file_.terminals(); }
  Line& line() { return *line_; }
  const Machine& machine() const { return *machine_; }

 private:
  gsbench::test::TemporaryFolder folder_;
  // Factory state: no settings in the flash.
  gsbench::emulation::SharedMemoryFile file_ =
      gsbench::test::demand(gsbench::emulation::SharedMemoryFile::create(
          folder_.path().string(), {"outlet-7", 77, 8000, 50, gsbench::models::kCounts_per_pu}));
  std::unique_ptr<Machine> machine_;
  std::unique_ptr<Line> line_;
};

}  // namespace gs::test
