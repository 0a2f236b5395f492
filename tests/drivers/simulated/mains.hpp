// A mains voltage to play, and a log of a simulated bench's messages and edges.
#pragma once

#include <firmware_test/settings.hpp>
#include <test_support/mains.hpp>
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <simulated/bench.hpp>

namespace gsbench::simulated::test {

using gs::wire::test::command;

constexpr std::int64_t kRate_hz = 8000;

// Nominal for 1 s, then falling by 0.5 Hz/s: causes an event, an estimate and a decision, and
// reaches the switch-off frequency that play() sets (49.8 Hz) after 0.4 s.
inline gsbench::test::Mains falling_mains(double duration_s, float noise_rms_pu = 0.0F,
                                          std::uint64_t seed = 1) {
  gsbench::test::Mains mains;
  mains.duration_s = duration_s;
  mains.falls_hz_s = 0.5;
  mains.added = {noise_rms_pu, seed};
  return mains;
}

// One outlet's messages and its contact's edges, each in order.
struct OutletLog {
  std::vector<gs::wire::Uplink> messages;
  std::vector<relay::Edge> edges;

  // Messages as encoded bytes, so that they compare bit for bit, including NaN; edges as text.
  std::vector<std::string> as_bytes() const {
    std::vector<std::string> all;
    for (const gs::wire::Uplink& message : messages) {
      const gs::wire::test::Bytes one = gs::wire::test::encoded(message, 0);
      all.emplace_back(one.begin(), one.end());
    }
    for (const relay::Edge& edge : edges) {
      all.push_back(std::to_string(edge.count) + (edge.closed ? " closed" : " open"));
    }
    return all;
  }

  std::vector<gs::wire::Uplink> of(gs::wire::UplinkKind kind) const {
    return gs::wire::test::of_kind(messages, kind);
  }
};

inline std::string id_of(std::size_t outlet) {
  return "outlet-" + std::to_string(outlet + 1);
}
inline std::size_t place_of(const std::string& id) {
  return std::stoul(id.substr(std::string("outlet-").size())) - 1;
}

inline BenchParameters bench_of(std::size_t outlets, std::size_t threads = 1) {
  BenchParameters parameters;
  for (std::size_t i = 0; i < outlets; ++i) {
    parameters.outlet_ids.push_back(id_of(i));
  }
  parameters.threads = threads;
  return parameters;
}

inline void poll(Bench& bench, std::vector<OutletLog>& logs) {
  link::Happenings happenings;
  std::vector<relay::Edge> edges;
  ASSERT_TRUE(bench.link().poll(happenings).ok());
  ASSERT_TRUE(happenings.faults.empty());
  ASSERT_TRUE(bench.relay_sense().poll(edges).ok());
  for (const link::Received& received : happenings.messages) {
    logs.at(place_of(received.id)).messages.push_back(received.message);
  }
  for (const relay::Edge& edge : edges) {
    logs.at(edge.channel).edges.push_back(edge);
  }
}

// Starts the bench, sends settings to each outlet and plays in blocks, whose lengths cycle through
// `block_ticks`.
inline std::vector<OutletLog> play(Bench& bench, std::size_t outlets,
                                   const source::Stimulus& stimulus,
                                   const std::vector<std::int64_t>& block_ticks) {
  std::vector<OutletLog> logs(outlets);
  gsbench::test::start(bench.source(), stimulus);
  EXPECT_TRUE(bench.link().open().ok());
  gs::outlet::Settings settings = gs::test::ieee24_settings();
  settings.method = gs::outlet::kByPaper;  // the mains falls as no grid does
  settings.switch_off_hz = 49.8F;
  for (std::size_t i = 0; i < outlets; ++i) {
    const auto sent = bench.link().send(id_of(i), gs::wire::test::settings_message(settings));
    EXPECT_TRUE(sent.ok());
  }
  std::size_t turn = 0;
  for (std::int64_t tick = 0; tick < stimulus.total_ticks();) {
    tick = std::min(tick + block_ticks[turn++ % block_ticks.size()], stimulus.total_ticks());
    gsbench::test::advance(bench.source(), tick);
    poll(bench, logs);
  }
  EXPECT_TRUE(bench.source().make_safe().ok());
  return logs;
}

}  // namespace gsbench::simulated::test
