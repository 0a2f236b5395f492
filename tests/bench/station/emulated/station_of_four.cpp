#include "station_of_four.hpp"

#include <chrono>
#include <utility>

namespace gsbench::station::test {

using record::Verdict;
using testing::HasSubstr;

namespace {

// Steady mains with marker dips before and after the run (bench/station/played_signal.cpp).
constexpr double kMarkers_s = 4.8;
// Wall time that a run may take in addition to what it plays: opening and closing the links,
// waiting for outlets, delays of a busy machine. A missing outlet must not delay a run further.
constexpr double kPatience_s = 15.0;
constexpr std::int64_t kTicksPerReport = 128;

}  // namespace

Outlets station_of_four() {
  using emulation::Connection;
  return {{"m4", "mps2-an386", Connection::kSerial, 40.0},
          {"host", "host", Connection::kSerial, -25.0},
          {"radio-a", "host", Connection::kMqtt, 12.0},
          {"radio-b", "host", Connection::kMqtt, -60.0}};
}

void FaultyStation::set_up(const Outlets& outlets) {
  station_.reset();
  emulation::HardwareOptions options;
  options.outlets = outlets;
  station_ = std::make_unique<EmulatedStation>("four", options, plan_);
}

void FaultyStation::at(double part, std::function<void()> fault) {
  faults_.push_back({part, std::move(fault)});
}

void FaultyStation::play() {
  RunOptions options;
  options.writer = writer_;
  options.progress = [this](double part) {
    for (Fault& fault : faults_) {
      if (!fault.injected && part >= fault.part) {
        fault.injected = true;
        fault.inject();
      }
    }
  };
  const auto begin = std::chrono::steady_clock::now();
  record_ = run(plan_, *station_, options);
  wall_s_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  EXPECT_LT(wall_s_, plan_.stimulus.duration_s + kMarkers_s + kPatience_s);
  for (const Fault& fault : faults_) {
    EXPECT_TRUE(fault.injected);
  }
  expect_safe_state();
}

void FaultyStation::expect_faults(const std::map<std::size_t, std::string>& faults) {
  EXPECT_EQ(record_.verdict, faults.empty() ? Verdict::kPass : Verdict::kError);
  ASSERT_EQ(record_.outlets.size(), plan_.outlets.size()) << record_.verdict_reason;
  if (!faults.empty()) {
    const auto& [first, what] = *faults.begin();
    EXPECT_THAT(record_.verdict_reason, HasSubstr("outlet " + record_.outlets[first].id + " "));
    EXPECT_THAT(record_.verdict_reason, HasSubstr(what));
  }
  for (std::size_t i = 0; i < record_.outlets.size(); ++i) {
    const record::OutletRecord& outlet = record_.outlets[i];
    const auto fault = faults.find(i);
    if (fault == faults.end()) {
      expect_complete(outlet);
    } else {
      EXPECT_EQ(outlet.verdict, Verdict::kError) << outlet.id;
      EXPECT_THAT(outlet.fault, HasSubstr(fault->second)) << outlet.id;
    }
  }
}

void FaultyStation::expect_complete(const record::OutletRecord& outlet) const {
  EXPECT_EQ(outlet.verdict, Verdict::kPass) << outlet.id;
  EXPECT_EQ(outlet.fault, "") << outlet.id;
  const std::vector<std::int64_t>& ticks = outlet.reports.trace.tick;
  // One report every 16 ms, the first and the last within 16 ms of the ends of the run.
  ASSERT_FALSE(ticks.empty()) << outlet.id;
  EXPECT_LE(ticks.front(), kTicksPerReport) << outlet.id;
  EXPECT_GE(ticks.back(), plan_.duration_ticks() - kTicksPerReport - 1) << outlet.id;
  for (std::size_t i = 1; i < ticks.size(); ++i) {
    // A crystal error of 100 ppm moves a report by 0.013 ticks, rounding moves it by up to one.
    ASSERT_NEAR(static_cast<double>(ticks[i] - ticks[i - 1]), kTicksPerReport, 1.0) << outlet.id;
  }
}

void FaultyStation::expect_safe_state() {
  EXPECT_FALSE(station_->source().advance(1).ok()) << "the source still plays";
  gs::wire::Downlink ping;
  ping.kind = gs::wire::DownlinkKind::kPing;
  std::size_t reached = 0;
  for (const record::OutletRecord& outlet : record_.outlets) {
    reached += station_->link().send(outlet.id, ping).ok() ? 1U : 0U;
  }
  EXPECT_EQ(reached, 0U) << "the link is still open";
}

}  // namespace gsbench::station::test
