#include "adc.hpp"
#include "shared_memory_file.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <emulation/mains.hpp>
#include <models/adc.hpp>
#include <models/relay_model.hpp>
#include <simulated/pacer.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using models::ContactEdge;
using models::kCountsPerPu;
using models::kFullScalePu;

namespace {

// Not faster than an outlet takes them: so far it may be behind. One that takes none for so long
// has ended, and the others do not wait for it.
constexpr std::uint32_t kMostBehind = 4096;
constexpr auto kGivenUpAfter = std::chrono::seconds(2);

// One outlet on the mains.
struct Outlet {
  Outlet(SharedMemoryFile file, double ppm) : terminal(std::move(file)), crystal_ppm(ppm) {}

  SharedMemoryFile terminal;
  double crystal_ppm;
  std::unique_ptr<Adc> adc;        // while the source plays
  std::uint32_t first_sample = 0;  // the terminal's count when the source began
  std::uint32_t edges_read = 0;
  std::uint64_t coil_changes = 0;
  std::vector<ContactEdge> contact;  // edges that the sense has still to tell, ascending
  bool given_up = false;
  std::vector<std::int16_t> samples;
};

struct Shared {
  explicit Shared(const MainsOptions& given) : options(given) {}

  MainsOptions options;
  std::vector<Outlet> outlets;
  std::int64_t tick = 0;
  std::uint64_t seed = 0;
  bool live = false;
};

class MainsSource final : public source::Source {
 public:
  explicit MainsSource(Shared& shared)
      : shared_(shared),
        pacer_(shared.options.real_time ? simulated::Pace::kRealTime : simulated::Pace::kVirtual) {}

  source::SourceInfo info() const override { return {"emulated mains", kFullScalePu, true}; }

  Status start(const source::SourceSettings& settings) override {
    if (settings.sample_rate_hz != shared_.options.sample_rate_hz ||
        settings.nominal_hz != shared_.options.nominal_hz) {
      return Error{"emulated mains: its outlets sample at " +
                   std::to_string(shared_.options.sample_rate_hz) + " Hz for mains of " +
                   std::to_string(shared_.options.nominal_hz) + " Hz"};
    }
    shared_.seed = settings.seed;
    for (std::size_t i = 0; i < shared_.outlets.size(); ++i) {
      Outlet& outlet = shared_.outlets[i];
      const models::Stream noise{settings.seed, models::kSourceNoise,
                                 static_cast<std::uint32_t>(i)};
      outlet.adc =
          std::make_unique<Adc>(outlet.crystal_ppm, kCountsPerPu, settings.noise_rms_pu, noise);
      // Nothing on the mains yet, while the adc counts: each outlet's count is another.
      const std::vector<std::int16_t> nothing(800 + 137 * i);
      outlet.terminal.write(nothing.data(), nothing.size());
      outlet.first_sample = outlet.terminal.terminals().written;
      outlet.given_up = false;
    }
    shared_.tick = 0;
    shared_.live = true;
    pacer_.start(settings.sample_rate_hz);
    return Done{};
  }

  Status play(std::int64_t first_tick, const float* voltage_pu, std::size_t count) override {
    if (!shared_.live || first_tick != shared_.tick) {
      return Error{"emulated mains: asked for tick " + std::to_string(first_tick) +
                   (shared_.live ? ", stands at " + std::to_string(shared_.tick)
                                 : " before it was started")};
    }
    Status playable = models::within_full_scale("emulated mains", first_tick, voltage_pu, count);
    if (!playable.ok()) {
      return playable;
    }
    if (first_tick == 0) {
      pacer_.restart();  // outlets that do not answer are waited for after the start
    }
    pacer_.wait_until(first_tick + static_cast<std::int64_t>(count));
    for (Outlet& outlet : shared_.outlets) {
      outlet.samples.clear();
      outlet.adc->take(voltage_pu, count, outlet.samples);
      outlet.terminal.write(outlet.samples.data(), outlet.samples.size());
      outlet.terminal.ring();
    }
    shared_.tick += static_cast<std::int64_t>(count);
    if (!shared_.options.real_time) {
      for (Outlet& outlet : shared_.outlets) {
        wait_for(outlet);
      }
    }
    return Done{};
  }

  void make_safe() noexcept override { shared_.live = false; }

 private:
  static void wait_for(Outlet& outlet) {
    const auto end = std::chrono::steady_clock::now() + kGivenUpAfter;
    while (!outlet.given_up && outlet.terminal.behind() > kMostBehind) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      outlet.given_up = std::chrono::steady_clock::now() > end;
    }
  }

  Shared& shared_;
  simulated::Pacer pacer_;
};

class TerminalRelaySense final : public relay::RelaySense {
 public:
  explicit TerminalRelaySense(Shared& shared) : shared_(shared) {}

  // Half a tick for the edge itself, half for the outlet's sample that its coil changed with.
  double uncertainty_ticks() const override { return 1.0; }

  Status poll(std::vector<relay::Edge>& edges) override {
    for (std::size_t i = 0; i < shared_.outlets.size(); ++i) {
      Outlet& outlet = shared_.outlets[i];
      follow_coil(outlet, i);
      const auto future =
          std::find_if(outlet.contact.begin(), outlet.contact.end(),
                       [&](const ContactEdge& edge) { return edge.tick >= shared_.tick; });
      for (auto edge = outlet.contact.begin(); edge != future; ++edge) {
        edges.push_back({i, edge->tick, edge->closed});
      }
      outlet.contact.erase(outlet.contact.begin(), future);
    }
    return Done{};
  }

 private:
  void follow_coil(Outlet& outlet, std::size_t index) {
    const gs::shared_memory_io::SharedMemory& terminals = outlet.terminal.terminals();
    for (const std::uint32_t there = terminals.edges; outlet.edges_read != there;
         ++outlet.edges_read) {
      const gs::shared_memory_io::PinEdge& pin =
          terminals.edge[outlet.edges_read % gs::shared_memory_io::kPinEdges];
      // Before the source began there is no tick to tell it by.
      const auto since = static_cast<std::int32_t>(pin.sample - outlet.first_sample);
      if (since < 0 || outlet.adc == nullptr) {
        continue;
      }
      const auto tick = static_cast<std::int64_t>(std::llround(outlet.adc->tick_of(since)));
      const models::Stream stream{shared_.seed, models::kRelayModel,
                                  static_cast<std::uint32_t>(index)};
      for (const ContactEdge& edge :
           contact_edges(models::RelayParameters(), stream, outlet.coil_changes, tick,
                         pin.closed != 0, shared_.options.sample_rate_hz)) {
        outlet.contact.push_back(edge);
      }
      ++outlet.coil_changes;
    }
  }

  Shared& shared_;
};

}  // namespace

struct Mains::Impl {
  explicit Impl(const MainsOptions& options)
      : shared(options), source(shared), relay_sense(shared) {}

  Shared shared;
  MainsSource source;
  TerminalRelaySense relay_sense;
};

Mains::Mains(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Mains::~Mains() = default;

Result<std::unique_ptr<Mains>> Mains::create(const MainsOptions& options) {
  auto impl = std::make_unique<Impl>(options);
  for (const MainsOutlet& outlet : options.outlets) {
    SharedMemorySettings settings;
    settings.id = outlet.id;
    settings.instance = static_cast<std::uint32_t>(impl->shared.outlets.size() + 1);
    settings.sample_rate_hz = static_cast<std::int32_t>(options.sample_rate_hz);
    settings.nominal_hz = options.nominal_hz;
    settings.counts_per_pu = kCountsPerPu;
    Result<SharedMemoryFile> file = SharedMemoryFile::create(options.folder, settings);
    if (!file.ok()) {
      return Error{file.error()};
    }
    impl->shared.outlets.emplace_back(file.take(), outlet.crystal_ppm);
  }
  return std::unique_ptr<Mains>(new Mains(std::move(impl)));
}

gs::shared_memory_io::SharedMemory& Mains::terminals(std::size_t outlet) {
  return impl_->shared.outlets.at(outlet).terminal.terminals();
}

const std::string& Mains::terminal_path(std::size_t outlet) const {
  return impl_->shared.outlets.at(outlet).terminal.path();
}
const std::string& Mains::doorbell_path(std::size_t outlet) const {
  return impl_->shared.outlets.at(outlet).terminal.doorbell();
}
source::Source& Mains::source() {
  return impl_->source;
}
relay::RelaySense& Mains::relay_sense() {
  return impl_->relay_sense;
}

}  // namespace gsbench::emulation
