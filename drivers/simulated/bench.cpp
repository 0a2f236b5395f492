#include <algorithm>
#include <utility>

#include <drivers/workers.hpp>
#include <simulated/bench.hpp>

namespace gsbench::simulated {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

// Shared by the three drivers: the outlets, and the tick played up to.
struct Shared {
  explicit Shared(const BenchParameters& p) : parameters(p) {
    for (std::uint32_t index = 0; index < p.outlet_ids.size(); ++index) {
      outlets.emplace_back(p.outlet, p.outlet_ids[index], index);
    }
  }

  BenchParameters parameters;
  std::vector<Outlet> outlets;
  std::int64_t tick = 0;
};

class SimulatedSource final : public source::Source {
 public:
  explicit SimulatedSource(std::shared_ptr<Shared> shared)
      : shared_(std::move(shared)),
        pacer_(shared_->parameters.pace),
        workers_(std::min(shared_->parameters.threads, shared_->outlets.size())) {}

  source::Limits limits() const override {
    source::Limits limits;
    limits.name = "simulated source";
    limits.full_scale_pu = models::kFullScale_pu;
    for (std::int64_t rate_hz = 1000; rate_hz <= gs::outlet::kMaxSampleRate_hz; rate_hz += 1000) {
      limits.sample_rates_hz.push_back(rate_hz);
    }
    limits.nominal_hz = {50, 60};
    limits.noise_per_outlet = true;
    return limits;
  }

 protected:
  Result<source::Played> deviation(const source::Stimulus&) const override {
    return source::Played{};
  }

  Status power_up() override {
    const source::Noise noise = stimulus().noise();
    for (Outlet& outlet : shared_->outlets) {
      if (!outlet.start(stimulus().sample_rate_hz(), stimulus().nominal_hz(), noise.rms_pu,
                        noise.seed)) {
        return Error{"simulated source: the firmware does not support a sample rate of " +
                     std::to_string(stimulus().sample_rate_hz()) + " Hz"};
      }
    }
    shared_->tick = 0;
    return Done{};
  }

  Status begin() override {
    pacer_.start(stimulus().sample_rate_hz());
    return Done{};
  }

  Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const std::int64_t first_tick = tick();
    const std::int64_t count = until_tick - first_tick;
    const Result<const float*> voltage_pu = samples(first_tick, count);
    if (!voltage_pu.ok()) {
      return Error{voltage_pu.error()};
    }
    pacer_.wait_until(first_tick);
    workers_.run(shared_->outlets.size(), [&](std::size_t outlet) {
      shared_->outlets[outlet].feed(first_tick, voltage_pu.value(),
                                    static_cast<std::size_t>(count));
    });
    shared_->tick = until_tick;
    return until_tick;
  }

  Status switch_off() noexcept override { return Done{}; }

 private:
  std::shared_ptr<Shared> shared_;
  Pacer pacer_;
  drivers::Workers workers_;
};

class SimulatedLink final : public link::Link {
 public:
  explicit SimulatedLink(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

  Status open() override { return Done{}; }

  Status send(const std::string& id, const gs::wire::Downlink& message) override {
    const std::vector<std::string>& ids = shared_->parameters.outlet_ids;
    const auto found = std::find(ids.begin(), ids.end(), id);
    if (found == ids.end()) {
      return Error{"the simulated link has no outlet " + id};
    }
    shared_->outlets[static_cast<std::size_t>(found - ids.begin())].send(shared_->tick, message);
    return Done{};
  }

  // An outlet joins when it gets power.
  Status poll(link::Happenings& happenings) override {
    for (std::size_t i = 0; i < shared_->outlets.size(); ++i) {
      const std::string& id = shared_->parameters.outlet_ids[i];
      inbox_.clear();
      shared_->outlets[i].take_messages(inbox_);
      for (const gs::wire::Uplink& message : inbox_) {
        if (message.kind == gs::wire::UplinkKind::kHello) {
          happenings.changes.emplace_back(link::OutletPresence{id, "simulated", message.hello});
        } else {
          happenings.messages.push_back({id, message});
        }
      }
    }
    return Done{};
  }

  void close() noexcept override {}

 private:
  std::shared_ptr<Shared> shared_;
  std::vector<gs::wire::Uplink> inbox_;
};

class SimulatedRelaySense final : public relay::RelaySense {
 public:
  explicit SimulatedRelaySense(std::shared_ptr<Shared> shared) : shared_(std::move(shared)) {}

  // Counts are the source's ticks.
  relay::Alignment alignment() const override { return {0.0, 1.0, 0.5}; }

  Status poll(std::vector<relay::Edge>& edges) override {
    for (std::size_t i = 0; i < shared_->outlets.size(); ++i) {
      contacts_.clear();
      shared_->outlets[i].take_edges(contacts_, shared_->tick);
      for (const models::ContactEdge& contact : contacts_) {
        edges.push_back({i, contact.tick, contact.closed});
      }
    }
    return Done{};
  }

 private:
  std::shared_ptr<Shared> shared_;
  std::vector<models::ContactEdge> contacts_;
};

}  // namespace

Bench::Bench(const BenchParameters& parameters) {
  const auto shared = std::make_shared<Shared>(parameters);
  source_ = std::make_unique<SimulatedSource>(shared);
  link_ = std::make_unique<SimulatedLink>(shared);
  relay_sense_ = std::make_unique<SimulatedRelaySense>(shared);
}

}  // namespace gsbench::simulated
