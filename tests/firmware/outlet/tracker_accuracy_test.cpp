// Accuracy of a steady frequency in 1 % white noise, over the whole range, and with the harmonics
// of EN 50160. `ctest --verbose -R Tracker` prints the figures.
#include <firmware_test/mains.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include <gtest/gtest.h>

#include <profile/load.hpp>

namespace gs::outlet {
namespace {

constexpr double kNoise_pct = 1.0;
constexpr double kSampleRate_hz = 8000.0;

struct Accuracy {
  double bias_mhz = 0.0;
  double rms_mhz = 0.0;  // against the reference, bias included
  double largest_mhz = 0.0;
  int measurements = 0;
  int not_valid = 0;
};

// Evaluated from 1 s on; the tracker settles in half of that.
Accuracy accuracy(const test::MainsSpec& spec, double duration_s) {
  test::PlayedOutlet outlet(spec);
  Accuracy a;
  double squares = 0.0;
  outlet.play(duration_s, [&](const Report& report) {
    if (test::report_s(report) < 1.0) {
      return;
    }
    if (report.measurement.validity != Validity::kValid) {
      ++a.not_valid;
      return;
    }
    const double error_mhz = 1e3 * (static_cast<double>(report.measurement.frequency_hz) -
                                    spec.reference->frequency_hz(test::measured_s(report)));
    a.bias_mhz += error_mhz;
    squares += error_mhz * error_mhz;
    a.largest_mhz = std::max(a.largest_mhz, std::abs(error_mhz));
    ++a.measurements;
  });
  a.bias_mhz /= a.measurements;
  a.rms_mhz = std::sqrt(squares / a.measurements);
  return a;
}

std::vector<gsbench::waveform::Harmonic> en50160() {
  const std::string text = R"(
    title = "Harmonics"
    source = "Test pattern after EN 50160"
    [grid]
    system = "ieee24"
    [signal]
    duration_s = 1.0
    sample_rate_hz = 8000
    frequency = [[0.0, 50.0]]
    harmonic_set = "en50160"
    [[outlet]]
    count = 1
    accumulated_mw = 0.0
    [[expect]]
    measure = "event.count"
    max = 0
  )";
  return gsbench::profile::parse_profile(text, "harmonics.toml").stimulus.signal.harmonics;
}

// Cramér–Rao bound of a constant frequency over `window_s` of a sine in white noise, mHz:
// var ω = 24·σ²/(A²·N³) rad² per sample².
double least_rms_mhz(double window_s) {
  const double samples = window_s * kSampleRate_hz;
  const double sigma = kNoise_pct / 100.0;
  return 1e3 * kSampleRate_hz / (2.0 * M_PI) * std::sqrt(24.0 * sigma * sigma) /
         std::pow(samples, 1.5);
}

struct Case {
  const char* name;
  double nominal_hz;
  bool harmonics;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.name;
}

class TrackerAccuracy : public testing::TestWithParam<Case> {
 protected:
  // Nominal ± 5 Hz. The limits are the requirement: bias 0.5 mHz, RMS 4 mHz, largest error 20 mHz.
  static void sweep(double step_hz, double duration_s) {
    const Case& c = GetParam();
    std::printf("   f/Hz   bias/mHz    rms/mHz    max/mHz\n");
    for (int i = 0; i * step_hz <= 10.0; ++i) {
      const double frequency_hz = c.nominal_hz - 5.0 + i * step_hz;
      test::MainsSpec spec = {test::steady(c.nominal_hz, frequency_hz), {}, kNoise_pct};
      spec.seed = static_cast<std::uint64_t>(i) + 1;
      if (c.harmonics) {
        spec.signal.harmonics = en50160();
      }
      const Accuracy a = accuracy(spec, duration_s);
      std::printf("%7.2f %10.3f %10.3f %10.3f\n", frequency_hz, a.bias_mhz, a.rms_mhz,
                  a.largest_mhz);
      EXPECT_EQ(a.not_valid, 0) << frequency_hz;
      EXPECT_NEAR(a.bias_mhz, 0.0, 0.5) << frequency_hz;
      EXPECT_LE(a.rms_mhz, 4.0) << frequency_hz;
      EXPECT_LE(a.largest_mhz, 20.0) << frequency_hz;
      // An error below the bound for a window of 0.25 s would mean that the reference leaks into
      // the measurement.
      EXPECT_GE(a.rms_mhz, least_rms_mhz(0.25)) << frequency_hz;
    }
  }
};

TEST_P(TrackerAccuracy, IsWithinFourMillihertzRmsUpToFiveHertzFromNominal) {
  sweep(0.5, 21.0);
}

constexpr Case kCases[] = {{"Grid50HzNoise", 50.0, false},
                           {"Grid50HzNoiseAndHarmonics", 50.0, true},
                           {"Grid60HzNoise", 60.0, false},
                           {"Grid60HzNoiseAndHarmonics", 60.0, true}};

std::string name_of(const testing::TestParamInfo<Case>& info) {
  return info.param.name;
}

INSTANTIATE_TEST_SUITE_P(Signals, TrackerAccuracy, testing::ValuesIn(kCases), name_of);

}  // namespace
}  // namespace gs::outlet
