#include "modem_lines.hpp"
#include "rigs.hpp"
#include <test_support/clocked_source.hpp>
#include <test_support/demand.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <vector>

#include <models/relay_model.hpp>

namespace gsbench::test {
namespace {

constexpr std::int64_t kModemRate_hz = 8000;
constexpr auto kTick = std::chrono::nanoseconds(1'000'000'000 / kModemRate_hz);
constexpr const char* kPorts[] = {"/dev/one", "/dev/two"};

// How the source's start is known: its true error, and the uncertainty that the source states.
struct Start {
  double late_s;
  double uncertainty_s;
};

// Two adapters in virtual time. The source's clock is 100 ppm slow.
class ModemLineRig final : public RelayRig {
 public:
  explicit ModemLineRig(const Start& known) : known_(known) {
    for (const char* port : kPorts) {
      lines_.set(port, TIOCM_CTS);
    }
    demand(sense_.open());
    start_ = lines_.now();
    source_.clock = {start_ - std::chrono::microseconds(std::llround(1e6 * known.late_s)),
                     1.0001 / kModemRate_hz, known.uncertainty_s};
  }
  ~ModemLineRig() override { lines_.end(); }

  relay::RelaySense& sense() override { return sense_; }
  void turn(std::size_t channel, bool closed) override {
    const models::Stream stream{1, models::kTest, static_cast<std::uint32_t>(channel)};
    for (const models::ContactEdge& edge :
         contact_edges({}, stream, turns_++, tick_, closed, kModemRate_hz)) {
      due_.push_back({edge.tick, channel, edge.closed});
    }
    std::stable_sort(due_.begin(), due_.end(),
                     [](const Due& a, const Due& b) { return a.tick < b.tick; });
  }
  void advance(std::int64_t until_tick) override {
    while (!due_.empty() && due_.front().tick < until_tick) {
      pass_until(due_.front().tick);
      lines_.set(kPorts[due_.front().channel], due_.front().closed ? TIOCM_CTS : 0);
      due_.erase(due_.begin());
    }
    pass_until(until_tick);
    tick_ = until_tick;
  }
  // Half of the 1 ms between readings, 1 ms of the adapter, half a tick, and that of the source.
  double most_uncertain_ticks() const override {
    return (0.0015 + known_.uncertainty_s) * kModemRate_hz + 0.5 + 0.1;
  }

 private:
  struct Due {
    std::int64_t tick;
    std::size_t channel;
    bool closed;
  };

  void pass_until(std::int64_t tick) {
    const auto end = start_ + std::chrono::nanoseconds(
                                  std::llround(static_cast<double>(tick * kTick.count()) * 1.0001));
    lines_.advance(end - lines_.now());
  }

  Start known_;
  ModemLines lines_;
  ClockedSource source_;
  relay::ModemLineSense sense_{
      {{{kPorts[0], relay::ModemLine::kCts}, {kPorts[1], relay::ModemLine::kCts}}, kModemRate_hz},
      source_,
      lines_.system()};
  steady_clock::time_point start_;
  std::int64_t tick_ = 0;
  std::uint64_t turns_ = 0;
  std::vector<Due> due_;
};

}  // namespace

std::unique_ptr<RelayRig> modem_line_sense() {
  return std::make_unique<ModemLineRig>(Start{0.0, 0.0001});
}

// The trigger's latency is not what the instrument's file states.
std::unique_ptr<RelayRig> modem_line_sense_of_a_generator() {
  return std::make_unique<ModemLineRig>(Start{0.0095, 0.01});
}

}  // namespace gsbench::test
