// A case as a profile has the same signal.
#include <test_support/temporary_folder.hpp>

#include <gtest/gtest.h>

#include <immunity/profile_text.hpp>
#include <profile/load.hpp>

namespace gsbench::immunity {
namespace {

TEST(ProfileOfACase, HasTheSameSignalForEachKind) {
  const test::TemporaryFolder folder;
  Options options;
  options.accumulated_mw = 2.5;
  for (std::uint32_t number = 26; number < 26 + kKinds.size(); ++number) {
    const Disturbance d = draw(50.0, 1, number);
    folder.write("case.toml", profile_text(d, number, "ieee24", options));
    const profile::Plan plan = profile::load_profile((folder.path() / "case.toml").string());
    const profile::Stimulus& played = plan.stimulus;
    EXPECT_EQ(played.noise_pct, 1.0);
    EXPECT_EQ(played.sample_rate_hz, kSampleRate_hz);
    EXPECT_GE(played.duration_s, d.end_s + kAfter_s);
    EXPECT_LT(played.duration_s, d.end_s + kAfter_s + 1.0);
    EXPECT_EQ(plan.outlets.at(0).settings.accumulated_mw, 2.5);
    ASSERT_EQ(played.oscillations.size(), d.oscillations.size());
    for (std::size_t i = 0; i < d.oscillations.size(); ++i) {
      EXPECT_NEAR(played.oscillations[i].amplitude_hz, d.oscillations[i].amplitude_hz, 1e-12);
      EXPECT_EQ(played.oscillations[i].frequency_hz, d.oscillations[i].frequency_hz);
      EXPECT_EQ(played.oscillations[i].duration_s, d.oscillations[i].duration_s);
      EXPECT_EQ(played.oscillations[i].phase_deg, d.oscillations[i].phase_deg);
    }
    const waveform::Synthesizer expected(plan.reference(), d.signal, kSampleRate_hz);
    const waveform::Synthesizer synthesizer = plan.synthesizer();
    std::vector<float> a(5 * kSampleRate_hz);
    std::vector<float> b(a.size());
    expected.render(10 * kSampleRate_hz, a.size(), a.data());
    synthesizer.render(10 * kSampleRate_hz, b.size(), b.data());
    EXPECT_EQ(a, b) << number;
  }
}

TEST(ProfileOfACase, HasLinesThatATerminalShowsWhole) {
  for (std::uint32_t number = 0; number < 3000; ++number) {
    std::istringstream keys(signal_keys(draw(60.0, 3, number), 1.0));
    for (std::string line; std::getline(keys, line);) {
      ASSERT_LE(line.size(), 98U) << line;
    }
  }
}

}  // namespace
}  // namespace gsbench::immunity
