#include "sample_run.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include <record/store.hpp>

namespace gsbench::sample {
namespace {

constexpr std::int64_t kSampleRate_hz = 8000;
constexpr std::int64_t kReportTicks = 128;  // 16 ms
constexpr double kLoss_s = 3.0;
constexpr double kTrackerDelay_s = 0.060;
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double seconds(std::int64_t tick) {
  return static_cast<double>(tick) / static_cast<double>(kSampleRate_hz);
}

std::int64_t ticks(double time_s) {
  return std::llround(time_s * static_cast<double>(kSampleRate_hz));
}

// Eq. (6) for a loss of 500 MW in the 24-bus system.
double true_frequency_hz(double time_s) {
  const double t = time_s - kLoss_s;
  if (t <= 0.0) {
    return 50.0;
  }
  const double decay = std::exp(-0.75352 * 0.39723 * t);
  return 50.0 - 0.391 * (1.0 + 3.82075 * decay * std::sin(0.26115 * t - 0.26481));
}

double true_rocof_hz_s(double time_s) {
  constexpr double kStep_s = 1e-4;
  if (time_s <= kLoss_s) {
    return 0.0;
  }
  return (true_frequency_hz(time_s + kStep_s) - true_frequency_hz(time_s)) / kStep_s;
}

// Uniform in ±1. The engine gives the same numbers with every library, the distributions of
// <random> do not.
class Noise {
 public:
  explicit Noise(std::uint32_t seed) : engine_(seed) {}
  double operator()() { return 2.0 * static_cast<double>(engine_()) / 4294967295.0 - 1.0; }

 private:
  std::mt19937 engine_;
};

record::MeasurementResult number(const char* name, double value, const char* unit, double low,
                                 double high, double uncertainty) {
  record::MeasurementResult result;
  result.name = name;
  result.definition = result.name + ", in a sentence about as long as those of the catalogue.";
  result.value = value;
  result.unit = unit;
  result.low = low;
  result.high = high;
  result.uncertainty = uncertainty;
  result.judged = !std::isnan(low) || !std::isnan(high);
  return result;
}

record::MeasurementResult text(const char* name, const char* value) {
  record::MeasurementResult result = number(name, kNone, "", kNone, kNone, 0.0);
  result.text = value;
  result.expected_text = value;
  result.judged = true;
  return result;
}

void measure(record::OutletRecord& outlet, bool sheds, double loss_mw, double event_delay_ms) {
  constexpr double kTick_ms = 0.125;
  outlet.measurements = {
      number("tracker.error.max", 18.42, "mHz", kNone, 60.0, 0.1),
      number("tracker.error.rms", 3.107, "mHz", kNone, 10.0, 0.05),
      number("event.false", 0.0, "", kNone, 0.0, 0.0),
      number("event.delay", event_delay_ms, "ms", kNone, 160.0, kTick_ms),
      number("condition.hits", 33.0, "", 15.0, kNone, 0.0),
      number("lse.loss", 310.4, "MW", kNone, kNone, 0.0),
      number("ekf.loss", loss_mw, "MW", kNone, kNone, 0.0),
      number("ekf.error", (loss_mw - 500.0) / 5.0, "%", -4.0, 4.0, 0.0),
      number("decision.delay", 920.0, "ms", kNone, 960.0, kTick_ms),
      text("decision.cause", sheds ? "loss" : "none"),
      number("relay.delay", sheds ? 926.375 : kNone, "ms", kNone, sheds ? 980.0 : kNone, kTick_ms),
      number("relay.delay_reported", sheds ? 920.0 : kNone, "ms", kNone, kNone, kTick_ms),
      number("relay.report_difference", sheds ? -6.375 : kNone, "ms", kNone, kNone, 0.18),
      text("relay.end", sheds ? "open" : "closed"),
  };
}

void trace(record::OutletRecord& outlet, std::int64_t duration_ticks, Noise& noise) {
  constexpr double kFrequencyNoise_hz = 0.003;
  constexpr double kRocofNoise_hz_s = 0.04;
  for (std::int64_t tick = kReportTicks; tick <= duration_ticks; tick += kReportTicks) {
    const double seen_s = seconds(tick) - kTrackerDelay_s;
    const bool settled = seconds(tick) > 0.2;
    const double frequency_hz =
        settled ? true_frequency_hz(seen_s) + kFrequencyNoise_hz * noise() : kNone;
    const double rocof_hz_s = true_rocof_hz_s(seen_s) + kRocofNoise_hz_s * noise();
    add_report(outlet.reports.trace, tick, frequency_hz, rocof_hz_s, 1.0 + 0.001 * noise(),
               settled);
  }
}

void estimate(record::OutletRecord& outlet, std::int64_t from_tick, std::int64_t to_tick,
              double final_mw, Noise& noise) {
  for (std::int64_t tick = from_tick; tick <= to_tick; tick += kReportTicks) {
    const double age_s = seconds(tick - from_tick);
    const double settling = std::exp(-age_s / 0.12);
    outlet.reports.estimates.tick.push_back(tick);
    outlet.reports.estimates.loss_mw.push_back(
        static_cast<float>(final_mw - 190.0 * settling + 6.0 * settling * noise()));
    outlet.reports.estimates.loss_sigma_mw.push_back(static_cast<float>(5.0 + 35.0 * settling));
    outlet.reports.estimates.event_tick.push_back(from_tick);
    outlet.reports.estimates.loss_after_event_s.push_back(
        static_cast<float>(kLoss_s - seconds(from_tick) + 0.02 * settling * noise()));
    outlet.reports.estimates.trusted.push_back(age_s > 0.1 ? 1 : 0);
  }
}

record::OutletRecord outlet_500mw(int number_from_1, bool sheds, std::int64_t duration_ticks) {
  Noise noise(static_cast<std::uint32_t>(number_from_1));
  record::OutletRecord outlet;
  outlet.id = (sheds ? "sheds-" : "stays-") + std::to_string(number_from_1);
  outlet.group = sheds ? "sheds" : "stays";
  outlet.link = "simulated";
  outlet.firmware = "0.1.0";
  outlet.board = "mps2-an386";
  outlet.instance = 0x12345678;
  outlet.build = "3f2a9c41";
  outlet.protocol_version = 3;
  outlet.reports.sent = {{-1, "settings", {0x83, 0x01, 0x00}},
                         {-1, "ask self test", {0x82, 0x05, 0x00}}};
  outlet.settings_digest = "5be1a0f2";
  outlet.settings = {{"accumulated_mw", sheds ? 100.0 : 200.0},
                     {"threshold_mw", 351.92},
                     {"switch_off_hz", 49.21},
                     {"k_lse_mw_per_hz_s", -1011.92}};
  const double loss_mw = 498.0 + 4.0 * noise();
  const std::int64_t last_report_before = ticks(kLoss_s) / kReportTicks * kReportTicks;
  const std::int64_t event = last_report_before + kReportTicks * (7 + number_from_1 % 3);
  const std::int64_t lse = event + 10 * kReportTicks;
  const std::int64_t decision = last_report_before + 58 * kReportTicks;
  measure(outlet, sheds, loss_mw, 1e3 * seconds(event - ticks(kLoss_s)));
  trace(outlet, duration_ticks, noise);
  estimate(outlet, lse, decision, loss_mw, noise);
  outlet.reports.marks = {{event, "event", 0.0, ""},
                          {lse, "lse", 310.4, ""},
                          {decision, "decision", sheds ? 1.0 : 0.0, sheds ? "loss" : "none"}};
  if (sheds) {
    outlet.reports.marks.push_back({decision, "relay.reported", 0.0, ""});
    outlet.reports.marks.push_back({decision + 51, "relay.sense", 0.0, ""});
  }
  return outlet;
}

record::RunRecord head(double duration_s) {
  record::RunRecord run;
  run.run_id = "20260301T101500Z-7f3a";
  run.started_utc = "2026-03-01T10:15:00Z";
  run.finished_utc = "2026-03-01T10:15:02Z";
  run.gsbench_version = "0.1.0";
  run.profile_sha256 = "9c1185a5c5e9fc54612808977ee8f548b2258d31ddf8d5a0e5c5b0a6a1f4a3b2";
  run.grid = "ieee24";
  run.station = "simulated";
  run.noise = "1 % white, independent at each outlet";
  run.firmware_sha256 = "3f2a9c41d0e1b7a65c2f8e90a4b1d7c63e5f0a9b8c7d6e5f4a3b2c1d0e9f8a7b";
  run.seed = 18446744073709551615U;
  run.sample_rate_hz = kSampleRate_hz;
  run.duration_ticks = ticks(duration_s);
  return run;
}

}  // namespace

record::RunRecord loss_500mw(int outlet_count) {
  record::RunRecord run = head(6.0);
  run.profile = "paper/loss-500mw";
  run.profile_title = "Loss of 500 MW in the modified IEEE 24-bus system";
  run.profile_source = "Xiang et al., §6.4";
  run.profile_text =
      "title = \"Loss of 500 MW in the modified IEEE 24-bus system\"\n\n[grid]\nsystem = "
      "\"ieee24\"\n[[grid.loss]]\nat_s = 3.0\npower_mw = 500.0\n\n[signal]\nduration_s = 6.0\n"
      "noise_pct = 1.0   # <white>\n";
  run.comparisons = {
      {"threshold loss", "MW", 351.92, 351.9, ""},
      {"time of the lowest frequency", "s", 3.7612, 3.72,
       "The paper's 3.72 s does not follow from its own machines: with those that give its "
       "threshold and its Table 1, eq. (6) bottoms at 3.76 s."}};
  for (std::int64_t tick = 0; tick <= run.duration_ticks; tick += 400) {
    run.reference.tick.push_back(tick);
    run.reference.frequency_hz.push_back(true_frequency_hz(seconds(tick)));
    run.reference.rocof_hz_s.push_back(true_rocof_hz_s(seconds(tick)));
  }
  run.stimulus = {{ticks(kLoss_s), "loss", 500.0, "loss of 500 MW"}};
  for (int i = 1; i <= outlet_count; ++i) {
    run.outlets.push_back(outlet_500mw(i, 2 * i <= outlet_count, run.duration_ticks));
  }
  run.content_sha256 = record::content_digest(run);
  return run;
}

record::RunRecord steady(int outlet_count, double duration_s) {
  record::RunRecord run = head(duration_s);
  run.profile = "regression/steady";
  run.profile_title = "Steady 50 Hz";
  run.reference.tick = {0, run.duration_ticks};
  run.reference.frequency_hz = {50.0, 50.0};
  run.reference.rocof_hz_s = {0.0, 0.0};
  for (int i = 1; i <= outlet_count; ++i) {
    Noise noise(static_cast<std::uint32_t>(i));
    record::OutletRecord outlet;
    outlet.id = "steady-" + std::to_string(i);
    double wander_hz = 0.0;
    for (std::int64_t tick = kReportTicks; tick <= run.duration_ticks; tick += kReportTicks) {
      wander_hz = 0.9 * wander_hz + 0.001 * noise();
      const double rocof_hz_s = 0.05 * noise();
      add_report(outlet.reports.trace, tick, 50.0 + wander_hz, rocof_hz_s, 1.0 + 0.001 * noise(),
                 true);
    }
    run.outlets.push_back(std::move(outlet));
  }
  return run;
}

void write(const std::string& path, const record::RunRecord& run) {
  record::Writer writer(path);
  writer.begin(run);
  for (const record::OutletRecord& outlet : run.outlets) {
    writer.add_outlet(outlet);
  }
  writer.finish(run);
}

void add_report(record::MeasurementTrace& trace, std::int64_t tick, double frequency_hz,
                double rocof_hz_s, double voltage_pu, bool valid) {
  trace.tick.push_back(tick);
  trace.frequency_hz.push_back(static_cast<float>(frequency_hz));
  trace.rocof_hz_s.push_back(static_cast<float>(rocof_hz_s));
  trace.voltage_pu.push_back(static_cast<float>(voltage_pu));
  trace.validity.push_back(valid ? 1 : 0);
}

record::MeasurementResult& measurement(record::OutletRecord& outlet, const std::string& name) {
  const auto found = std::find_if(outlet.measurements.begin(), outlet.measurements.end(),
                                  [&](const auto& result) { return result.name == name; });
  if (found == outlet.measurements.end()) {
    throw std::out_of_range(name);
  }
  return *found;
}

}  // namespace gsbench::sample
