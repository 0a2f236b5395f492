// Source and relay sense of emulated outlets, directly at their terminals
// (emulation/terminals.hpp), without an instrument in between. The outlets' ADCs have counted some
// samples before the stimulus. Source and relay sense share state: use them from one thread.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/terminals.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gsbench::emulation {

struct MainsOptions {
  std::string folder;  // for the files that the emulators map; best on a memory file system
  std::vector<MainsOutlet> outlets;
  std::int64_t sample_rate_hz = 8000;
  int nominal_hz = 50;
  bool real_time = true;  // false: as fast as the outlets process samples
};

struct MainsState;

class Mains {
 public:
  static drivers::Result<std::unique_ptr<Mains>> create(const MainsOptions& options);

  // Arguments for the outlet's process.
  const std::string& terminal_path(std::size_t outlet) const;
  const std::string& doorbell_path(std::size_t outlet) const;

  // Not to be used while the source is energised.
  Terminals& outlets();
  // For fault injection.
  gs::shared_memory_io::SharedMemory& terminals(std::size_t outlet);

  // Owned by this object.
  source::Source& source() { return *source_; }
  relay::RelaySense& relay_sense() { return *relay_sense_; }

 private:
  explicit Mains(std::shared_ptr<MainsState> state);

  std::shared_ptr<MainsState> state_;
  std::unique_ptr<source::Source> source_;
  std::unique_ptr<relay::RelaySense> relay_sense_;
};

}  // namespace gsbench::emulation
