#include "example_truths.hpp"

#include <functional>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>

namespace gsbench::waveform {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Refusal {
  const char* name;
  std::function<void(SignalSpec&)> change;
  const char* message;
};

class RefusedSignal : public testing::TestWithParam<Refusal> {};

TEST_P(RefusedSignal, IsNamedWithItsValue) {
  SignalSpec spec;
  GetParam().change(spec);
  EXPECT_THAT([&spec] { const Synthesizer synthesizer(constant(50.0, 50.0), spec, 4000); },
              ThrowsMessage<std::invalid_argument>(HasSubstr(GetParam().message)));
}

INSTANTIATE_TEST_SUITE_P(
    Signal, RefusedSignal,
    testing::Values(
        Refusal{"OrderOne",
                [](auto& s) {
                  s.harmonics = {{1, 1, 0}};
                },
                "harmonic order 1: must be"},
        Refusal{"OrderTooHigh",
                [](auto& s) {
                  s.harmonics = {{51, 1, 0}};
                },
                "harmonic order 51"},
        Refusal{"OrderTwice",
                [](auto& s) {
                  s.harmonics = {{3, 1, 0}, {5, 1, 0}, {3, 2, 0}};
                },
                "harmonic 3 is given twice"},
        Refusal{"OrderAliases",
                [](auto& s) {
                  s.harmonics = {{40, 1, 0}};
                },
                "harmonic 40 of 50 Hz is 2000 Hz: must lie below half of the sample rate of 4000"},
        Refusal{"AmplitudeNegative",
                [](auto& s) {
                  s.harmonics = {{3, -1, 0}};
                },
                "harmonic 3: amplitude in % -1"},
        Refusal{"PhaseNan",
                [](auto& s) {
                  s.harmonics = {{3, 1, kNan}};
                },
                "harmonic 3: phase"},
        Refusal{"StepBeforeStart",
                [](auto& s) {
                  s.amplitude_steps = {{-1, 1, 50}};
                },
                "amplitude step: time in s -1"},
        Refusal{"StepWithoutLength",
                [](auto& s) {
                  s.amplitude_steps = {{1, 0, 50}};
                },
                "duration in s 0: must be above 0"},
        Refusal{"StepLengthNan",
                [](auto& s) {
                  s.amplitude_steps = {{1, kNan, 50}};
                },
                "duration in s nan"},
        Refusal{"StepNegative",
                [](auto& s) {
                  s.amplitude_steps = {{1, 1, -5}};
                },
                "amplitude step: level in % -5"},
        Refusal{"JumpNever",
                [](auto& s) {
                  s.phase_jumps = {{kInfinity, 5}};
                },
                "phase jump: time in s inf"},
        Refusal{"JumpNan",
                [](auto& s) {
                  s.phase_jumps = {{1, kNan}};
                },
                "phase jump: degrees nan"},
        Refusal{"DcTooMuch", [](auto& s) { s.dc_offset_pct = 101; }, "DC offset in % 101"},
        Refusal{"InitialPhase", [](auto& s) { s.initial_phase_deg = kInfinity; },
                "initial phase in degrees inf"}),
    [](const auto& param_info) { return std::string(param_info.param.name); });

TEST(SampleRate, MustMakeSixteenMillisecondsAWholeNumberOfSamples) {
  for (const std::int64_t rate_hz : {-8000, 0, 999, 1500, 44100, 8001, 1'001'000}) {
    EXPECT_THAT([&] { const Synthesizer synthesizer(constant(50.0, 50.0), {}, rate_hz); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("sample rate")))
        << rate_hz;
  }
  for (const std::int64_t rate_hz : {1000, 4000, 8000, 10000, 1'000'000}) {
    EXPECT_EQ(Synthesizer(constant(50.0, 50.0), {}, rate_hz).sample_rate_hz(), rate_hz);
  }
}

TEST(Signal, NeedsATruth) {
  EXPECT_THROW(Synthesizer(nullptr, {}, 8000), std::invalid_argument);
}

TEST(Signal, DoesNotBeginBeforeTickZero) {
  const Synthesizer synthesizer(constant(50.0, 50.0), {}, 8000);
  EXPECT_THROW(render(synthesizer, -1, 10), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::waveform
