#include "shared_memory_file.hpp"
#include <shared_memory_io/shared_port.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <emulation/terminals.hpp>
#include <models/adc.hpp>
#include <models/crystal_adc.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using models::ContactEdge;
using models::kCounts_per_pu;

namespace {

// wait_for_outlets() waits for an outlet that is more than kMostBehind samples behind. If the
// outlet is still behind after kGivenUpAfter, it has ended.
constexpr std::uint32_t kMostBehind = 4096;
constexpr auto kGivenUpAfter = std::chrono::seconds(2);

}  // namespace

struct Terminals::Outlet {
  Outlet(SharedMemoryFile file, const MainsOutlet& options, const TerminalsOptions& all)
      : terminal(std::move(file)), crystal_ppm(options.crystal_ppm), port(terminal.terminals()) {
    if (options.frequency_relay) {
      relay.emplace(*options.frequency_relay, all.sample_rate_hz, all.nominal_hz, kCounts_per_pu);
    }
  }

  void write(const std::vector<std::int16_t>& counts) {
    terminal.write(counts.data(), counts.size());
    terminal.ring();
    if (relay) {
      std::int16_t sample = 0;
      std::uint32_t lost = 0;
      while (port.take_samples(&sample, 1, lost) == 1) {
        port.drive_relay(relay->take(sample));
      }
    }
  }

  SharedMemoryFile terminal;
  double crystal_ppm;
  std::optional<FrequencyRelay> relay;  // uses the terminals in place of a process
  gs::shared_memory_io::SharedPort port;
  std::unique_ptr<models::CrystalAdc> adc;  // from connect() on
  std::uint32_t first_sample = 0;           // the terminal's sample count at step 0
  std::uint32_t edges_read = 0;
  std::uint64_t coil_changes = 0;
  std::vector<ContactEdge> contact;  // edges not taken yet, ascending
  bool given_up = false;
  std::vector<std::int16_t> samples;
};

Terminals::Terminals(const TerminalsOptions& options) : options_(options) {}
Terminals::~Terminals() = default;

Result<std::unique_ptr<Terminals>> Terminals::create(const TerminalsOptions& options) {
  std::unique_ptr<Terminals> terminals(new Terminals(options));
  for (const MainsOutlet& outlet : options.outlets) {
    Result<SharedMemoryFile> file = SharedMemoryFile::create(
        options.folder,
        {outlet.id, static_cast<std::uint32_t>(terminals->size() + 1),
         static_cast<std::int32_t>(options.sample_rate_hz), options.nominal_hz, kCounts_per_pu});
    if (!file.ok()) {
      return Error{file.error()};
    }
    terminals->outlets_.push_back(std::make_unique<Outlet>(file.take(), outlet, options));
  }
  return terminals;
}

const std::string& Terminals::path(std::size_t outlet) const {
  return outlets_.at(outlet)->terminal.path();
}

const std::string& Terminals::doorbell(std::size_t outlet) const {
  return outlets_.at(outlet)->terminal.doorbell();
}

gs::shared_memory_io::SharedMemory& Terminals::memory(std::size_t outlet) {
  return outlets_.at(outlet)->terminal.terminals();
}

void Terminals::write(std::size_t outlet, const std::vector<std::int16_t>& samples) {
  outlets_.at(outlet)->write(samples);
}

void Terminals::connect(std::int64_t step_rate_hz, const source::Noise& noise) {
  step_rate_hz_ = step_rate_hz;
  seed_ = noise.seed;
  const double samples_per_step =
      static_cast<double>(options_.sample_rate_hz) / static_cast<double>(step_rate_hz);
  for (std::size_t i = 0; i < outlets_.size(); ++i) {
    Outlet& outlet = *outlets_[i];
    const models::Stream stream{noise.seed, models::kSourceNoise, static_cast<std::uint32_t>(i)};
    outlet.adc = std::make_unique<models::CrystalAdc>(outlet.crystal_ppm, kCounts_per_pu,
                                                      noise.rms_pu, stream, samples_per_step);
    outlet.given_up = false;
    outlet.first_sample = outlet.terminal.terminals().written;
  }
}

void Terminals::feed(const float* voltage_pu, std::size_t count) {
  for (const auto& outlet : outlets_) {
    outlet->samples.clear();
    outlet->adc->take(voltage_pu, count, outlet->samples);
    outlet->write(outlet->samples);
  }
}

void Terminals::wait_for_outlets() {
  for (const auto& outlet : outlets_) {
    const auto end = std::chrono::steady_clock::now() + kGivenUpAfter;
    while (!outlet->given_up && outlet->terminal.behind() > kMostBehind) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      outlet->given_up = std::chrono::steady_clock::now() > end;
    }
  }
}

void Terminals::take_edges(std::size_t outlet, std::int64_t end_step,
                           std::vector<ContactEdge>& edges) {
  follow_coil(outlet);
  std::vector<ContactEdge>& contact = outlets_.at(outlet)->contact;
  const auto future = std::find_if(contact.begin(), contact.end(),
                                   [&](const ContactEdge& edge) { return edge.tick >= end_step; });
  edges.insert(edges.end(), contact.begin(), future);
  contact.erase(contact.begin(), future);
}

void Terminals::follow_coil(std::size_t index) {
  Outlet& outlet = *outlets_.at(index);
  const gs::shared_memory_io::SharedMemory& memory = outlet.terminal.terminals();
  for (const std::uint32_t there = memory.edges; outlet.edges_read != there; ++outlet.edges_read) {
    const gs::shared_memory_io::PinEdge& pin =
        memory.edge[outlet.edges_read % gs::shared_memory_io::kPinEdges];
    // Edges before step 0 have no step.
    const auto since = static_cast<std::int32_t>(pin.sample - outlet.first_sample);
    if (since < 0 || outlet.adc == nullptr) {
      continue;
    }
    const auto step = static_cast<std::int64_t>(std::llround(outlet.adc->tick_of(since)));
    const models::Stream stream{seed_, models::kRelayModel, static_cast<std::uint32_t>(index)};
    for (const ContactEdge& edge :
         contact_edges(models::RelayParameters(), stream, outlet.coil_changes, step,
                       pin.closed != 0, step_rate_hz_)) {
      outlet.contact.push_back(edge);
    }
    ++outlet.coil_changes;
  }
}

}  // namespace gsbench::emulation
