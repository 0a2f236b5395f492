#include <algorithm>

#include <drivers/workers.hpp>
#include <simulated/bench.hpp>

namespace gsbench::simulated {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

// What the three drivers share: the outlets, and how far the mains has got.
struct Shared {
  explicit Shared(const BenchParameters& p) : parameters(p) {
    for (std::uint32_t index = 0; index < p.outlet_ids.size(); ++index) {
      outlets.emplace_back(p.outlet, p.outlet_ids[index], index);
    }
  }

  BenchParameters parameters;
  std::vector<Outlet> outlets;
  std::int64_t tick = 0;
  bool live = false;
};

class SimulatedSource final : public source::Source {
 public:
  explicit SimulatedSource(Shared& shared)
      : shared_(shared),
        pacer_(shared.parameters.pace),
        workers_(std::min(shared.parameters.threads, shared.outlets.size())) {}

  source::SourceInfo info() const override { return {"simulated", kFullScalePu, true}; }

  Status start(const source::SourceSettings& settings) override {
    for (Outlet& outlet : shared_.outlets) {
      if (!outlet.start(settings.sample_rate_hz, settings.nominal_hz, settings.noise_rms_pu,
                        settings.seed)) {
        return Error{"simulated outlets: the firmware serves no " +
                     std::to_string(settings.sample_rate_hz) + " Hz at " +
                     std::to_string(settings.nominal_hz) + " Hz nominal"};
      }
    }
    shared_.tick = 0;
    shared_.live = true;
    pacer_.start(settings.sample_rate_hz);
    return Done{};
  }

  Status play(std::int64_t first_tick, const float* voltage_pu, std::size_t count) override {
    if (!shared_.live) {
      return Error{"simulated source: asked to play before it was started"};
    }
    if (first_tick != shared_.tick) {
      return Error{"simulated source: asked for tick " + std::to_string(first_tick) +
                   ", stands at " + std::to_string(shared_.tick)};
    }
    Status playable = within_full_scale("simulated source", first_tick, voltage_pu, count);
    if (!playable.ok()) {
      return playable;
    }
    if (first_tick == 0) {
      pacer_.restart();
    }
    pacer_.wait_until(first_tick);
    workers_.run(shared_.outlets.size(), [&](std::size_t outlet) {
      shared_.outlets[outlet].feed(first_tick, voltage_pu, count);
    });
    shared_.tick += static_cast<std::int64_t>(count);
    return Done{};
  }

  void make_safe() noexcept override { shared_.live = false; }

 private:
  Shared& shared_;
  Pacer pacer_;
  drivers::Workers workers_;
};

class SimulatedLink final : public link::Link {
 public:
  explicit SimulatedLink(Shared& shared) : shared_(shared) {}

  std::string name() const override { return "simulated"; }

  Result<std::vector<link::OutletPresence>> open() override {
    std::vector<link::OutletPresence> present;
    std::vector<gs::wire::Uplink> messages;
    for (std::size_t i = 0; i < shared_.outlets.size(); ++i) {
      messages.clear();
      shared_.outlets[i].take_messages(messages);
      for (const gs::wire::Uplink& message : messages) {
        if (message.kind == gs::wire::UplinkKind::kHello) {
          present.push_back({shared_.parameters.outlet_ids[i], name(), message.hello});
        }
      }
    }
    if (present.size() != shared_.outlets.size()) {
      return Error{"simulated link: not every outlet said hello; start the source first"};
    }
    return present;
  }

  Status send(std::size_t outlet, const gs::wire::Downlink& message) override {
    if (outlet >= shared_.outlets.size()) {
      return Error{"simulated link: no outlet " + std::to_string(outlet)};
    }
    shared_.outlets[outlet].send(shared_.tick, message);
    return Done{};
  }

  Status poll(std::vector<link::Received>& messages, std::vector<link::Fault>&) override {
    for (std::size_t i = 0; i < shared_.outlets.size(); ++i) {
      inbox_.clear();
      shared_.outlets[i].take_messages(inbox_);
      for (const gs::wire::Uplink& message : inbox_) {
        messages.push_back({i, message});
      }
    }
    return Done{};
  }

  void close() noexcept override {}

 private:
  Shared& shared_;
  std::vector<gs::wire::Uplink> inbox_;
};

class SimulatedRelaySense final : public relay::RelaySense {
 public:
  explicit SimulatedRelaySense(Shared& shared) : shared_(shared) {}

  double uncertainty_ticks() const override { return 0.5; }

  Status poll(std::vector<relay::Edge>& edges) override {
    for (std::size_t i = 0; i < shared_.outlets.size(); ++i) {
      contacts_.clear();
      shared_.outlets[i].take_edges(contacts_, shared_.tick);
      for (const ContactEdge& contact : contacts_) {
        edges.push_back({i, contact.tick, contact.closed});
      }
    }
    return Done{};
  }

 private:
  Shared& shared_;
  std::vector<ContactEdge> contacts_;
};

}  // namespace

struct Bench::Impl {
  explicit Impl(const BenchParameters& parameters)
      : shared(parameters), source(shared), link(shared), relay_sense(shared) {}

  Shared shared;
  SimulatedSource source;
  SimulatedLink link;
  SimulatedRelaySense relay_sense;
};

Bench::Bench(const BenchParameters& parameters) : impl_(std::make_unique<Impl>(parameters)) {}
Bench::~Bench() = default;

source::Source& Bench::source() {
  return impl_->source;
}
link::Link& Bench::link() {
  return impl_->link;
}
relay::RelaySense& Bench::relay_sense() {
  return impl_->relay_sense;
}

}  // namespace gsbench::simulated
