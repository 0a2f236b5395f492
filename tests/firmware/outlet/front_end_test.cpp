#include <firmware_test/mains.hpp>
#include <firmware_test/settings.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <outlet/front_end.hpp>
#include <outlet/outlet.hpp>
#include <waveform/oscillation.hpp>

namespace gs::outlet {
namespace {

Hardware hardware(std::int32_t sample_rate_hz, std::int32_t nominal_hz) {
  Hardware h;
  h.sample_rate_hz = sample_rate_hz;
  h.nominal_hz = nominal_hz;
  return h;
}

TEST(FrontEnd, SupportsEveryWholeKilohertzUpToItsLimitOnBothGrids) {
  FrontEndConfig config;
  for (const std::int32_t nominal_hz : {50, 60}) {
    for (std::int32_t rate = 1000; rate <= kMaxSampleRate_hz; rate += 1000) {
      ASSERT_TRUE(make_front_end(hardware(rate, nominal_hz), config)) << rate;
      EXPECT_EQ(config.samples_per_ms, rate / 1000);
      EXPECT_LE(config.table_length, kMaxTable);
      // The phase repeats after whole turns only.
      EXPECT_EQ(static_cast<std::int64_t>(config.table_length) * nominal_hz % rate, 0);
    }
  }
}

TEST(FrontEnd, RefusesUnsupportedHardware) {
  FrontEndConfig config;
  for (const std::int32_t rate : {-1000, 0, 500, 1500, 8001, 33000, 64000}) {
    EXPECT_FALSE(make_front_end(hardware(rate, 50), config)) << rate;
  }
  for (const std::int32_t nominal_hz : {-50, 0, 16, 49, 55, 400}) {
    EXPECT_FALSE(make_front_end(hardware(8000, nominal_hz), config)) << nominal_hz;
  }
  for (const float counts : {0.0F, -1.0F, 0.5F, 32768.0F, std::numeric_limits<float>::infinity(),
                             std::numeric_limits<float>::quiet_NaN()}) {
    Hardware h = hardware(8000, 50);
    h.counts_per_pu = counts;
    EXPECT_FALSE(make_front_end(h, config)) << counts;
  }
}

bool same_bits(float a, float b) {
  std::uint32_t bits_a = 0;
  std::uint32_t bits_b = 0;
  std::memcpy(&bits_a, &a, sizeof bits_a);
  std::memcpy(&bits_b, &b, sizeof bits_b);
  return bits_a == bits_b;
}

void expect_same(const Report& a, const Report& b) {
  ASSERT_EQ(a.number, b.number);
  ASSERT_TRUE(same_bits(a.measurement.frequency_hz, b.measurement.frequency_hz)) << a.number;
  ASSERT_TRUE(same_bits(a.measurement.rocof_hz_s, b.measurement.rocof_hz_s)) << a.number;
  ASSERT_TRUE(same_bits(a.measurement.voltage_pu, b.measurement.voltage_pu)) << a.number;
  ASSERT_EQ(a.measurement.validity, b.measurement.validity);
  ASSERT_TRUE(same_bits(a.line.slope_hz_s, b.line.slope_hz_s)) << a.number;
  ASSERT_TRUE(same_bits(a.loss_mw, b.loss_mw)) << a.number;
  ASSERT_TRUE(same_bits(a.loss_instant_s, b.loss_instant_s)) << a.number;
  ASSERT_EQ(a.happened, b.happened);
  ASSERT_EQ(a.hits, b.hits);
  ASSERT_EQ(a.relay_closed, b.relay_closed);
}

// Reports for samples fed in pieces; next_length() returns the length of each.
template <class NextLength>
std::vector<Report> reports_in_pieces(const test::MainsSpec& mains,
                                      const std::vector<std::int16_t>& samples,
                                      NextLength next_length) {
  test::PlayedOutlet outlet(mains, test::ieee24_settings());
  std::vector<Report> reports;
  std::size_t at = 0;
  while (at < samples.size()) {
    const std::size_t end = std::min(samples.size(), at + next_length());
    while (at < end) {
      Report report;
      bool ready = false;
      at += step(outlet.config, outlet.state, samples.data() + at, end - at, report, ready);
      if (ready) {
        reports.push_back(report);
      }
    }
  }
  return reports;
}

void expect_same_for_all_block_sizes(const test::MainsSpec& mains, std::size_t duration_s) {
  const auto rate = static_cast<std::size_t>(mains.sample_rate_hz);
  const auto samples = test::Mains(mains).samples(0, duration_s * rate);
  const std::vector<Report> whole =
      reports_in_pieces(mains, samples, [&] { return samples.size(); });
  ASSERT_EQ(whole.size(), duration_s * 1000 / 16);
  EXPECT_TRUE(std::any_of(whole.begin(), whole.end(), [](const Report& report) {
    return (report.happened & kDecision) != 0;
  })) << "the samples must lead to a decision";

  std::mt19937 generator(1);
  const std::size_t per_report = rate * 16 / 1000;
  for (const std::size_t longest :
       {std::size_t{1}, std::size_t{7}, per_report, per_report + 1, 5 * per_report}) {
    const std::vector<Report> cut =
        reports_in_pieces(mains, samples, [&] { return std::size_t{1} + generator() % longest; });
    ASSERT_EQ(cut.size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
      expect_same(cut[i], whole[i]);
    }
  }
}

TEST(FrontEnd, ReportsDoNotDependOnTheSizesOfSampleBlocks) {
  for (const std::int32_t rate : {1000, 4000, 8000, 32000}) {
    expect_same_for_all_block_sizes({test::loss_of(600.0, 0.7), {}, 1.0, 1, rate}, 2);
  }
}

// A dip and an oscillation cause work that is spread over the time between two reports.
TEST(FrontEnd, ReportsDoNotDependOnTheSizesOfSampleBlocksInAnOscillation) {
  gsbench::waveform::Oscillation oscillation;
  oscillation.at_s = 2.0;
  oscillation.frequency_hz = 0.6;
  oscillation.amplitude_hz = 0.04;
  test::MainsSpec mains;
  mains.reference = gsbench::waveform::with_oscillations(
      gsbench::waveform::reference_from_losses(gsbench::grid::SfrModel(test::ieee24()),
                                               {{5.0, 600.0}}),
      {oscillation});
  mains.signal.amplitude_steps = {{3.0, 0.1, 40.0}, {5.3, 0.1, 40.0}};
  mains.noise_pct = 1.0;
  expect_same_for_all_block_sizes(mains, 8);
}

// ---- The filter, measured with tones.

struct Complex {
  double re;
  double im;
};

Complex settled_phasor(const FrontEndConfig& config, double rate_hz, double tone_hz,
                       double phase_rad) {
  constexpr double kAmplitude = 32000.0;
  std::vector<std::int16_t> samples(static_cast<std::size_t>(rate_hz * 0.064));
  for (std::size_t n = 0; n < samples.size(); ++n) {
    const double angle = 2.0 * M_PI * tone_hz * static_cast<double>(n) / rate_hz + phase_rad;
    samples[n] = static_cast<std::int16_t>(std::lround(kAmplitude * std::cos(angle)));
  }
  FrontEndState state;
  bool ready = false;
  for (std::size_t at = 0; at < samples.size();) {
    at += feed(config, state, samples.data() + at, samples.size() - at, ready);
  }
  const Phasor p = phasor(state);
  EXPECT_TRUE(ready && p.complete);
  const double scale = 1.0 / (kAmplitude * static_cast<double>(config.pu_per_count));
  return {scale * static_cast<double>(p.in_phase), scale * static_cast<double>(p.quadrature)};
}

// Gain at `offset_hz` from the nominal frequency, relative to the amplitude of a real tone. Cosine
// and sine together give the response to e^(jωt) = cos + j·sin, which has no image.
double gain(std::int32_t rate_hz, std::int32_t nominal_hz, double offset_hz) {
  static FrontEndConfig config;
  EXPECT_TRUE(make_front_end(hardware(rate_hz, nominal_hz), config));
  const double tone_hz = nominal_hz + offset_hz;
  const Complex c = settled_phasor(config, rate_hz, tone_hz, 0.0);
  const Complex s = settled_phasor(config, rate_hz, tone_hz, -0.5 * M_PI);
  return 0.5 * std::hypot(c.re - s.im, c.im + s.re);
}

double decibels(double x) {
  return 20.0 * std::log10(x);
}

// Largest gain over a band and its mirror image below the nominal frequency.
double largest_db(std::int32_t rate_hz, std::int32_t nominal_hz, double from_hz, double to_hz) {
  double largest = 0.0;
  for (double offset = from_hz; offset <= to_hz; offset += 0.5) {
    largest =
        std::max({largest, gain(rate_hz, nominal_hz, offset), gain(rate_hz, nominal_hz, -offset)});
  }
  return decibels(largest);
}

class FrontEndFilter : public testing::TestWithParam<std::pair<std::int32_t, std::int32_t>> {};

TEST_P(FrontEndFilter, PassesTheFundamentalWithItsAmplitude) {
  const auto [rate_hz, nominal_hz] = GetParam();
  // Tolerance for rounding of the table, 1/16384, and of the filter's taps.
  EXPECT_NEAR(gain(rate_hz, nominal_hz, 0.0), 1.0, 1e-4);
  // Attenuation at 5 Hz offset increases noise but causes no error.
  EXPECT_GT(gain(rate_hz, nominal_hz, 5.0), 0.9);
  EXPECT_GT(gain(rate_hz, nominal_hz, -5.0), 0.9);
}

TEST_P(FrontEndFilter, AttenuatesAsItsHeaderDeclares) {
  const auto [rate_hz, nominal_hz] = GetParam();
  const double second_harmonic = largest_db(rate_hz, nominal_hz, 40.0, 60.0);
  const double image = largest_db(rate_hz, nominal_hz, 85.0, 125.0);
  EXPECT_LT(second_harmonic, -43.0);
  EXPECT_LT(image, -73.0);
  EXPECT_LT(largest_db(rate_hz, nominal_hz, 60.0, 85.0), -51.0);
  EXPECT_LT(largest_db(rate_hz, nominal_hz, 125.0, 480.0), -51.0);
  // Lower bounds, so that a filter with no output fails.
  EXPECT_GT(second_harmonic, -46.0);
  EXPECT_GT(image, -76.0);
}

std::string name_of(const testing::TestParamInfo<FrontEndFilter::ParamType>& rates) {
  return std::to_string(rates.param.first) + "HzOnA" + std::to_string(rates.param.second) +
         "HzGrid";
}

INSTANTIATE_TEST_SUITE_P(Rates, FrontEndFilter,
                         testing::Values(std::pair{1000, 50}, std::pair{4000, 50},
                                         std::pair{8000, 50}, std::pair{8000, 60},
                                         std::pair{32000, 60}),
                         name_of);

// Not at 1000 Hz: there the sums are single samples, and all aliasing is that of the ADC.
TEST(FrontEnd, AttenuatesAliasesOfItsSumsAsDeclared) {
  for (const auto& [rate_hz, nominal_hz] :
       {std::pair{4000, 50}, std::pair{8000, 60}, std::pair{32000, 50}}) {
    EXPECT_LT(largest_db(rate_hz, nominal_hz, 520.0, 960.0), -51.0) << rate_hz;
    EXPECT_LT(largest_db(rate_hz, nominal_hz, 960.0, 1040.0), -39.0) << rate_hz;
    EXPECT_LT(decibels(gain(rate_hz, nominal_hz, 1000.0)), -60.0) << rate_hz;
  }
}

TEST(FrontEnd, MeasuresTheVoltageAtOffNominalFrequencies) {
  for (const double frequency_hz : {45.0, 48.0, 50.0, 52.0, 55.0}) {
    for (const double level_pct : {20.0, 100.0, 120.0}) {
      test::MainsSpec spec = {test::steady(50.0, frequency_hz)};
      spec.signal.amplitude_steps = {{0.0, 100.0, level_pct}};
      for (const Report& report : test::reports_of(spec, 1.0, test::ieee24_settings())) {
        if (report.number < 4) {
          continue;
        }
        // 50 ms are then not a whole number of half periods. sin(x)/x of the squared signal's
        // ripple at 90 and 110 Hz leaves up to 7 % of the mean square, 3.5 % of the RMS.
        EXPECT_NEAR(static_cast<double>(report.measurement.voltage_pu), 0.01 * level_pct,
                    0.01 * level_pct * 0.04)
            << frequency_hz;
      }
    }
  }
}

}  // namespace
}  // namespace gs::outlet
