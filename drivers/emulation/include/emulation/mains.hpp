// The mains at emulated outlets, and the bench's eye on their relays: source and relay sense over
// their terminals. Each outlet has an ADC on a crystal of its own, some ppm off, that began to
// count before the stimulus does; its relay's contact follows the coil as the simulated one does.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <relay/relay_sense.hpp>
#include <source/source.hpp>

namespace gs::shared_memory_io {
struct SharedMemory;
}

namespace gsbench::emulation {

struct MainsOutlet {
  std::string id;
  double crystal_ppm = 0.0;  // by how much it is fast
};

struct MainsOptions {
  std::string folder;  // for the files that the emulators map; in memory, best
  std::vector<MainsOutlet> outlets;
  std::int64_t sample_rate_hz = 8000;
  int nominal_hz = 50;
  bool real_time = true;  // false: as fast as the outlets take samples
};

struct MainsState;

class Mains {
 public:
  static drivers::Result<std::unique_ptr<Mains>> create(const MainsOptions& options);

  // For the outlet's process.
  const std::string& terminal_path(std::size_t outlet) const;
  const std::string& doorbell_path(std::size_t outlet) const;

  // For faults on purpose.
  gs::shared_memory_io::SharedMemory& terminals(std::size_t outlet);

  // These live as long as the mains.
  source::Source& source() { return *source_; }
  relay::RelaySense& relay_sense() { return *relay_sense_; }

 private:
  explicit Mains(std::shared_ptr<MainsState> state);

  std::shared_ptr<MainsState> state_;
  std::unique_ptr<source::Source> source_;
  std::unique_ptr<relay::RelaySense> relay_sense_;
};

}  // namespace gsbench::emulation
