#include <cmath>

#include <emulation/mains.hpp>
#include <models/adc.hpp>
#include <simulated/pacer.hpp>
#include <source/fundamental.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using models::kCounts_per_pu;

// Shared by source and relay sense: all outlets, and the tick played up to.
struct MainsState {
  MainsOptions options;
  std::unique_ptr<Terminals> terminals;
  std::int64_t tick = 0;
};

namespace {

constexpr double kPi = 3.14159265358979323846;

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
    state_->tick = 0;
    Terminals& terminals = *state_->terminals;
    for (std::size_t i = 0; i < terminals.size(); ++i) {
      // A different sample count for each outlet.
      terminals.write(i, nominal_counts(800 + 137 * i));
    }
    terminals.connect(state_->options.sample_rate_hz, stimulus().noise());
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
    state_->terminals->feed(voltage_pu.value(), static_cast<std::size_t>(count));
    state_->tick = until_tick;
    if (!state_->options.real_time) {
      state_->terminals->wait_for_outlets();
    }
    return until_tick;
  }

  Status switch_off() noexcept override { return Done{}; }

 private:
  // `count` samples of nominal voltage, in phase with the beginning of the stimulus.
  std::vector<std::int16_t> nominal_counts(std::size_t count) {
    const double step_rad = 2.0 * kPi * static_cast<double>(state_->options.nominal_hz) /
                            static_cast<double>(state_->options.sample_rate_hz);
    const double phase_rad = std::arg(source::fundamental_pu(stimulus(), 0));
    std::vector<std::int16_t> counts(count);
    for (std::size_t n = 0; n < count; ++n) {
      const double angle_rad = phase_rad - step_rad * static_cast<double>(count - n);
      counts[n] = models::adc_counts(static_cast<float>(std::cos(angle_rad)), kCounts_per_pu);
    }
    return counts;
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
    for (std::size_t i = 0; i < state_->terminals->size(); ++i) {
      taken_.clear();
      state_->terminals->take_edges(i, state_->tick, taken_);
      for (const models::ContactEdge& edge : taken_) {
        edges.push_back({i, edge.tick, edge.closed});
      }
    }
    return Done{};
  }

 private:
  std::shared_ptr<MainsState> state_;
  std::vector<models::ContactEdge> taken_;
};

}  // namespace

Mains::Mains(std::shared_ptr<MainsState> state)
    : state_(std::move(state)),
      source_(std::make_unique<MainsSource>(state_)),
      relay_sense_(std::make_unique<TerminalRelaySense>(state_)) {}

Result<std::unique_ptr<Mains>> Mains::create(const MainsOptions& options) {
  const auto state = std::make_shared<MainsState>();
  state->options = options;
  if (const Status made = Terminals::create({options.folder, options.outlets,
                                             options.sample_rate_hz, options.nominal_hz})
                              .move_to(state->terminals);
      !made.ok()) {
    return Error{made.error()};
  }
  return std::unique_ptr<Mains>(new Mains(state));
}

Terminals& Mains::outlets() {
  return *state_->terminals;
}

gs::shared_memory_io::SharedMemory& Mains::terminals(std::size_t outlet) {
  return state_->terminals->memory(outlet);
}

const std::string& Mains::terminal_path(std::size_t outlet) const {
  return state_->terminals->path(outlet);
}

const std::string& Mains::doorbell_path(std::size_t outlet) const {
  return state_->terminals->doorbell(outlet);
}

}  // namespace gsbench::emulation
