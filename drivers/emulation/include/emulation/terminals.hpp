// The outlets' ends of the mains: an ADC on its own crystal for each outlet, whose samples go into
// the shared memory of the outlet's process, and the contact that follows the coil which the
// process drives (models/relay_model.hpp). A contact-only outlet is a frequency relay in this
// process. Fed with voltage samples at a stated rate, by the direct source (emulation/mains.hpp) or
// by the wire from an instrument (emulation/wire.hpp). Used by one thread at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <drivers/result.hpp>
#include <emulation/frequency_relay.hpp>
#include <models/relay_model.hpp>
#include <source/stimulus.hpp>

namespace gs::shared_memory_io {
struct SharedMemory;
}

namespace gsbench::emulation {

struct MainsOutlet {
  std::string id;
  double crystal_ppm = 0.0;  // positive: fast
  // A contact-only device; none: an outlet's process is to use the terminals.
  std::optional<FrequencyRelayOptions> frequency_relay = {};
};

struct TerminalsOptions {
  std::string folder;  // for the files that the emulators map; best on a memory file system
  std::vector<MainsOutlet> outlets;
  std::int64_t sample_rate_hz = 8000;  // of the outlets' ADCs, nominal
  int nominal_hz = 50;
};

class Terminals {
 public:
  static drivers::Result<std::unique_ptr<Terminals>> create(const TerminalsOptions& options);
  ~Terminals();

  std::size_t size() const { return outlets_.size(); }
  // Arguments for the outlet's process.
  const std::string& path(std::size_t outlet) const;
  const std::string& doorbell(std::size_t outlet) const;
  // For fault injection.
  gs::shared_memory_io::SharedMemory& memory(std::size_t outlet);

  // Samples that the outlet's ADC made before connect().
  void write(std::size_t outlet, const std::vector<std::int16_t>& samples);

  // Starts the ADCs. Input steps count from 0 from now on, at `step_rate_hz`; `noise` is added to
  // the samples of each outlet, independently. Its seed determines the contacts, too.
  void connect(std::int64_t step_rate_hz, const source::Noise& noise);

  // The next input steps: voltage per unit of nominal peak. After connect() only.
  void feed(const float* voltage_pu, std::size_t count);

  // Without real time: waits for outlets that are far behind. An outlet that stays behind has
  // ended; it is not waited for again.
  void wait_for_outlets();

  // Appends the edges of the outlet's contact before `end_step` that were not taken yet, in order
  // of time, in input steps. If an outlet's process is behind, an edge may be appended late, with
  // its true step.
  void take_edges(std::size_t outlet, std::int64_t end_step,
                  std::vector<models::ContactEdge>& edges);

 private:
  struct Outlet;

  explicit Terminals(const TerminalsOptions& options);
  void follow_coil(std::size_t outlet);

  TerminalsOptions options_;
  std::vector<std::unique_ptr<Outlet>> outlets_;
  std::int64_t step_rate_hz_ = 0;
  std::uint64_t seed_ = 0;
};

}  // namespace gsbench::emulation
