// Emulated instruments play to emulated outlets through the drivers of physical ones.
#include "plans.hpp"
#include <test_support/temporary_folder.hpp>

#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include <profile/load.hpp>
#include <station/dry_run.hpp>
#include <station/run.hpp>
#include <station/station_file.hpp>

namespace gsbench::station::test {
namespace {

using gsbench::record::Mark;

constexpr const char* kModemPlan =
    "title = \"A loss\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[[grid.loss]]\n"
    "at_s = 0.5\npower_mw = 600.0\n[signal]\nduration_s = 3.0\nnoise_pct = 0.5\n"
    "[[outlet]]\ncount = 2\naccumulated_mw = 50.0\n"
    "[[expect]]\nmeasure = \"relay.end\"\nequals = \"open\"\n";

constexpr const char* kModemStation =
    "title = \"A station\"\nkind = \"emulated\"\n"
    "[source]\nkind = \"head\"\ngain = 236.0\nvoltage_limit_v = 265.0\nboot_s = 2.0\n"
    "clock_error_ppm = 30.0\n[relay]\nkind = \"modem\"\n"
    "[[outlet]]\nid = \"host\"\ncrystal_ppm = 90.0\n"
    "[[outlet]]\nid = \"relay\"\nboard = \"frequency-relay\"\npickup_hz = 49.5\n"
    "delay_s = 0.1\n";

class OnAnInstrument : public testing::Test {
 protected:
  void play(const StationFile& file, const profile::Plan& plan) {
    const auto station = file.make_station(plan, {});
    const DryRun dry = dry_run(plan, *station);
    record_ = run(plan, *station, {});
    ASSERT_EQ(record_.fault, "");
    expect_predicted_relay_sense(dry);
  }
  void play_shipped(const char* station, const char* profile) {
    const StationFile file = load_station(station);
    play(file, fit_to_station(file, profile::load_profile(profile)));
    EXPECT_EQ(record_.verdict, record::Verdict::kPass) << record_.verdict_reason;
  }

  void expect_predicted_relay_sense(const DryRun& dry) const {
    const DryRun::Clock& predicted = dry.clocks.at(1);
    ASSERT_EQ(predicted.what, "relay sense");
    EXPECT_EQ(predicted.aligned_by, record_.clocks.at(1).aligned_by);
    const double uncertainty_ms = record_.clocks.at(1).uncertainty_ms;
    if (predicted.not_known_yet.empty()) {
      EXPECT_DOUBLE_EQ(predicted.uncertainty_ms, uncertainty_ms);
    } else {
      EXPECT_LT(predicted.uncertainty_ms, uncertainty_ms);
      EXPECT_GT(predicted.uncertainty_ms, 0.1);
    }
  }

  // The outlet measured nominal voltage in the first half second, and this drift of its crystal
  // against the instrument's.
  void expect_nominal_voltage_and_drift(std::size_t outlet, double drift_ppm) const {
    const record::OutletRecord& measured = record_.outlets.at(outlet);
    double sum_pu = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < measured.reports.trace.tick.size(); ++i) {
      if (measured.reports.trace.tick[i] < 4000) {
        sum_pu += static_cast<double>(measured.reports.trace.voltage_pu[i]);
        ++count;
      }
    }
    ASSERT_GE(count, 20);
    EXPECT_NEAR(sum_pu / count, 1.0, 0.01);
    // The instrument plays in real time, so that the noise differs from run to run. The uncertainty
    // is expanded with k = 2, beyond which one value in twenty lies; three standard deviations.
    EXPECT_NEAR(measured.clock.drift_ppm, drift_ppm, 1.5 * measured.clock.drift_uncertainty_ppm);
    EXPECT_LT(measured.clock.drift_uncertainty_ppm, 150.0);
    EXPECT_LT(measured.clock.uncertainty_ms, 1.0);
  }

  std::int64_t tick_of(std::size_t outlet, const char* kind) const {
    for (const Mark& mark : record_.outlets.at(outlet).reports.marks) {
      if (mark.kind == kind) {
        return mark.tick;
      }
    }
    ADD_FAILURE() << "outlet " << outlet << " has no " << kind;
    return 0;
  }
  // The contact follows the coil after 6.5 ms to 9.5 ms.
  void expect_operate_time(std::size_t outlet, double most_uncertain_ms) const {
    const double sense_ms = record_.bench_uncertainty.relay_sense_ms;
    EXPECT_GT(sense_ms, 0.0);
    EXPECT_LT(sense_ms, most_uncertain_ms);
    const double operate_ms =
        static_cast<double>(tick_of(outlet, "relay.sense") - tick_of(outlet, "decision")) / 8.0;
    const double within_ms = sense_ms + record_.outlets[outlet].clock.uncertainty_ms;
    EXPECT_GT(operate_ms, 6.5 - within_ms);
    EXPECT_LT(operate_ms, 9.5 + within_ms);
  }

  const gsbench::test::TemporaryFolder folder_;
  record::RunRecord record_;
};

TEST_F(OnAnInstrument, AGeneratorPlaysAndTheTerminalsSense) {
  play_shipped("scpi-emulated", "paper/loss-500mw");
  expect_nominal_voltage_and_drift(0, 40.0 - 1.5);
  expect_nominal_voltage_and_drift(1, -60.0 - 1.5);
  expect_operate_time(0, 1.0);
}

// The bench believes that the generator starts 10 ± 10 ms after its trigger; the emulated one does
// within 1 ms. The contact takes 6.5 ms to 9.5 ms, the message and the outlet's process the rest.
TEST_F(OnAnInstrument, ACommandIsTimedByTheVoltageAndNotByTheGeneratorsTrigger) {
  play_shipped("scpi-emulated", "regression/command");
  const auto* const delay = record::find_measurement(record_.outlets.at(0), "command.delay");
  ASSERT_NE(delay, nullptr);
  EXPECT_GT(delay->uncertainty, 0.1);
  EXPECT_LT(delay->uncertainty, 0.5);
  EXPECT_GT(delay->value, 6.5 - delay->uncertainty);
  EXPECT_LT(delay->value, 9.5 + 4.0);
}

TEST_F(OnAnInstrument, AHeadPlaysAndSenses) {
  play_shipped("head-emulated", "paper/loss-500mw");
  expect_nominal_voltage_and_drift(0, 40.0 + 8.0);
  expect_nominal_voltage_and_drift(1, -60.0 + 8.0);
  expect_operate_time(0, 0.5);
}

TEST_F(OnAnInstrument, AContactOnlyDeviceIsJudgedWithoutAnInstrumentToo) {
  play_shipped("contact-only", "regression/contact-only");
  EXPECT_EQ(record_.outlets.at(0).link, "");
  EXPECT_TRUE(record_.outlets.at(0).reports.trace.tick.empty()) << "it cannot report";
}

// The head's ticks are known on this machine's clock, and a modem line is read on it.
TEST_F(OnAnInstrument, ModemLinesSenseAnOutletAndAContactOnlyDevice) {
  const StationFile file = load_station(folder_.write("instrument.toml", kModemStation));
  const profile::Plan plan = parse(kModemPlan);
  play(file, plan);
  ASSERT_EQ(record_.outlets.size(), 2U);
  expect_nominal_voltage_and_drift(0, 90.0 - 30.0);
  expect_operate_time(0, 5.0);
  const double uncertainty_ms = record_.bench_uncertainty.relay_sense_ms;
  EXPECT_GT(uncertainty_ms, 1.5) << "half a millisecond of the readings, and the adapter's";
  double below_s = 0.5;
  while (plan.reference()->frequency_hz(below_s) > 49.5) {
    below_s += 1e-3;
  }
  // 100 ms of delay, 50 to 120 ms of measurement, 6.5 to 9.5 ms of the contact.
  const double opened_s = static_cast<double>(tick_of(1, "relay.sense")) / 8000.0;
  EXPECT_GT(opened_s, below_s + 0.15 - 1e-3 * uncertainty_ms);
  EXPECT_LT(opened_s, below_s + 0.24 + 1e-3 * uncertainty_ms);
}

}  // namespace
}  // namespace gsbench::station::test
