#include "shared_memory_file.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include <emulation/mains.hpp>
#include <models/adc.hpp>
#include <models/crystal_adc.hpp>
#include <models/relay_model.hpp>
#include <simulated/pacer.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using models::ContactEdge;
using models::kCounts_per_pu;

// Shared by source and relay sense: all outlets, and the tick played up to.
struct MainsState {
  struct Outlet {
    Outlet(SharedMemoryFile file, double ppm) : terminal(std::move(file)), crystal_ppm(ppm) {}

    SharedMemoryFile terminal;
    double crystal_ppm;
    std::unique_ptr<models::CrystalAdc> adc;  // from power-up on
    std::uint32_t first_sample = 0;           // the terminal's sample count at tick 0
    std::uint32_t edges_read = 0;
    std::uint64_t coil_changes = 0;
    std::vector<ContactEdge> contact;  // edges that poll() has not returned yet, ascending
    bool given_up = false;
    std::vector<std::int16_t> samples;
  };

  MainsOptions options;
  std::vector<Outlet> outlets;
  std::int64_t tick = 0;
  std::uint64_t seed = 0;
};

namespace {

// Without real time, the source waits for an outlet that is more than kMostBehind samples behind.
// If the outlet is still behind after kGivenUpAfter, it has ended, and the source stops waiting.
constexpr std::uint32_t kMostBehind = 4096;
constexpr double kPi = 3.14159265358979323846;
constexpr auto kGivenUpAfter = std::chrono::seconds(2);

using Outlet = MainsState::Outlet;

class MainsSource final : public source::Source {
 public:
  explicit MainsSource(std::shared_ptr<MainsState> state)
      : state_(std::move(state)),
        pacer_(state_->options.real_time ? simulated::Pace::kRealTime : simulated::Pace::kVirtual) {
  }

  source::Limits limits() const override {
    source::Limits limits;
    limits.name = "emulated mains";
    limits.full_scale_pu = models::kFullScale_pu;
    limits.sample_rates_hz = {state_->options.sample_rate_hz};
    limits.nominal_hz = {state_->options.nominal_hz};
    limits.noise_per_outlet = true;
    return limits;
  }

 protected:
  Result<source::Played> deviation(const source::Stimulus&) const override {
    return source::Played{};
  }

  Status power_up() override {
    const source::Noise noise = stimulus().noise();
    state_->seed = noise.seed;
    state_->tick = 0;
    for (std::size_t i = 0; i < state_->outlets.size(); ++i) {
      Outlet& outlet = state_->outlets[i];
      const models::Stream stream{noise.seed, models::kSourceNoise, static_cast<std::uint32_t>(i)};
      outlet.adc = std::make_unique<models::CrystalAdc>(outlet.crystal_ppm, kCounts_per_pu,
                                                        noise.rms_pu, stream);
      outlet.given_up = false;
      // A different sample count for each outlet.
      if (Status fed = feed_nominal(outlet, 800 + 137 * i); !fed.ok()) {
        return fed;
      }
      outlet.first_sample = outlet.terminal.terminals().written;
    }
    return Done{};
  }

  Status begin() override {
    pacer_.start(state_->options.sample_rate_hz);
    return Done{};
  }

  Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const std::int64_t count = until_tick - tick();
    const Result<const float*> voltage_pu = samples(tick(), count);
    if (!voltage_pu.ok()) {
      return Error{voltage_pu.error()};
    }
    pacer_.wait_until(until_tick);
    for (Outlet& outlet : state_->outlets) {
      outlet.samples.clear();
      outlet.adc->take(voltage_pu.value(), static_cast<std::size_t>(count), outlet.samples);
      outlet.terminal.write(outlet.samples.data(), outlet.samples.size());
      outlet.terminal.ring();
    }
    state_->tick = until_tick;
    if (!state_->options.real_time) {
      for (Outlet& outlet : state_->outlets) {
        wait_for(outlet);
      }
    }
    return until_tick;
  }

  Status switch_off() noexcept override { return Done{}; }

 private:
  // `count` samples of nominal voltage, in phase with the stimulus's first two samples.
  Status feed_nominal(Outlet& outlet, std::size_t count) {
    const Result<const float*> first = samples(0, 2);
    if (!first.ok()) {
      return Error{first.error()};
    }
    const auto at_0 = static_cast<double>(first.value()[0]);
    const auto at_1 = static_cast<double>(first.value()[1]);
    const double step_rad = 2.0 * kPi * static_cast<double>(state_->options.nominal_hz) /
                            static_cast<double>(state_->options.sample_rate_hz);
    const double phase_rad =
        std::atan2((at_0 * std::cos(step_rad) - at_1) / std::sin(step_rad), at_0);
    outlet.samples.resize(count);
    for (std::size_t n = 0; n < count; ++n) {
      const double angle_rad = phase_rad - step_rad * static_cast<double>(count - n);
      outlet.samples[n] =
          models::adc_counts(static_cast<float>(std::cos(angle_rad)), kCounts_per_pu);
    }
    outlet.terminal.write(outlet.samples.data(), count);
    outlet.terminal.ring();
    return Done{};
  }

  static void wait_for(Outlet& outlet) {
    const auto end = std::chrono::steady_clock::now() + kGivenUpAfter;
    while (!outlet.given_up && outlet.terminal.behind() > kMostBehind) {
      std::this_thread::sleep_for(std::chrono::microseconds(200));
      outlet.given_up = std::chrono::steady_clock::now() > end;
    }
  }

  std::shared_ptr<MainsState> state_;
  simulated::Pacer pacer_;
};

class TerminalRelaySense final : public relay::RelaySense {
 public:
  explicit TerminalRelaySense(std::shared_ptr<MainsState> state) : state_(std::move(state)) {}

  // Counts are the source's ticks. Uncertainty: half a tick for the edge, half for the outlet's
  // sample at which the coil changed.
  relay::Alignment alignment() const override { return {0.0, 1.0, 1.0}; }

  Status poll(std::vector<relay::Edge>& edges) override {
    for (std::size_t i = 0; i < state_->outlets.size(); ++i) {
      Outlet& outlet = state_->outlets[i];
      follow_coil(outlet, i);
      const auto future =
          std::find_if(outlet.contact.begin(), outlet.contact.end(),
                       [&](const ContactEdge& edge) { return edge.tick >= state_->tick; });
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
      // Edges before tick 0 have no tick.
      const auto since = static_cast<std::int32_t>(pin.sample - outlet.first_sample);
      if (since < 0 || outlet.adc == nullptr) {
        continue;
      }
      const auto tick = static_cast<std::int64_t>(std::llround(outlet.adc->tick_of(since)));
      const models::Stream stream{state_->seed, models::kRelayModel,
                                  static_cast<std::uint32_t>(index)};
      for (const ContactEdge& edge :
           contact_edges(models::RelayParameters(), stream, outlet.coil_changes, tick,
                         pin.closed != 0, state_->options.sample_rate_hz)) {
        outlet.contact.push_back(edge);
      }
      ++outlet.coil_changes;
    }
  }

  std::shared_ptr<MainsState> state_;
};

}  // namespace

Mains::Mains(std::shared_ptr<MainsState> state)
    : state_(std::move(state)),
      source_(std::make_unique<MainsSource>(state_)),
      relay_sense_(std::make_unique<TerminalRelaySense>(state_)) {}

Result<std::unique_ptr<Mains>> Mains::create(const MainsOptions& options) {
  const auto state = std::make_shared<MainsState>();
  state->options = options;
  for (const MainsOutlet& outlet : options.outlets) {
    Result<SharedMemoryFile> file = SharedMemoryFile::create(
        options.folder,
        {outlet.id, static_cast<std::uint32_t>(state->outlets.size() + 1),
         static_cast<std::int32_t>(options.sample_rate_hz), options.nominal_hz, kCounts_per_pu});
    if (!file.ok()) {
      return Error{file.error()};
    }
    state->outlets.emplace_back(file.take(), outlet.crystal_ppm);
  }
  return std::unique_ptr<Mains>(new Mains(state));
}

gs::shared_memory_io::SharedMemory& Mains::terminals(std::size_t outlet) {
  return state_->outlets.at(outlet).terminal.terminals();
}

const std::string& Mains::terminal_path(std::size_t outlet) const {
  return state_->outlets.at(outlet).terminal.path();
}

const std::string& Mains::doorbell_path(std::size_t outlet) const {
  return state_->outlets.at(outlet).terminal.doorbell();
}

}  // namespace gsbench::emulation
