// A model of a logic analyser: counts at 1 MHz on its own crystal, from before the stimulus.
#include "rigs.hpp"

#include <deque>

#include <models/relay_model.hpp>

namespace gsbench::test {
namespace {

constexpr double kCountsPerTick = 1e6 * (1.0 + 50e-6) / 8000.0;
constexpr double kCountAtTick0 = 987654321.0;

class CounterSense final : public relay::RelaySense {
 public:
  relay::Alignment alignment() const override { return {kCountAtTick0, kCountsPerTick, 0.5}; }

  drivers::Status poll(std::vector<relay::Edge>& edges) override {
    for (std::size_t channel = 0; channel < 2; ++channel) {
      std::deque<models::ContactEdge>& contact = contacts[channel];
      for (; !contact.empty() && contact.front().tick < tick; contact.pop_front()) {
        const double count =
            kCountAtTick0 + kCountsPerTick * static_cast<double>(contact.front().tick);
        edges.push_back({channel, std::llround(count), contact.front().closed});
      }
    }
    return drivers::Done{};
  }

  std::int64_t tick = 0;
  std::deque<models::ContactEdge> contacts[2];
};

class CounterRig final : public RelayRig {
 public:
  relay::RelaySense& sense() override { return sense_; }
  void turn(std::size_t channel, bool closed) override {
    const models::Stream stream{1, models::kTest, static_cast<std::uint32_t>(channel)};
    for (const models::ContactEdge& edge :
         contact_edges({}, stream, turns_++, sense_.tick, closed, 8000)) {
      sense_.contacts[channel].push_back(edge);
    }
  }
  void advance(std::int64_t until_tick) override { sense_.tick = until_tick; }

 private:
  CounterSense sense_;
  std::uint64_t turns_ = 0;
};

}  // namespace

std::unique_ptr<RelayRig> counter_sense() {
  return std::make_unique<CounterRig>();
}

}  // namespace gsbench::test
