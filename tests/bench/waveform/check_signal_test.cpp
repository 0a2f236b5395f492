#include "example_references.hpp"

#include <limits>
#include <stdexcept>
#include <utility>

#include <gmock/gmock.h>

namespace gsbench::waveform {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A signal with the value of one field.
template <class Field>
SignalSpec with(Field SignalSpec::*field, Field value) {
  SignalSpec spec;
  spec.*field = std::move(value);
  return spec;
}

TEST(CheckSignal, RefusesWithFieldAndValue) {
  const std::pair<SignalSpec, const char*> refused[] = {
      {with(&SignalSpec::harmonics, {{1, 1, 0}}), "harmonic order is 1, the fundamental"},
      {with(&SignalSpec::harmonics, {{0, 1, 0}}), "harmonic order is 0; it must be"},
      {with(&SignalSpec::harmonics, {{kNan, 1, 0}}), "harmonic order is nan"},
      {with(&SignalSpec::harmonics, {{2.5, 1, 0}, {2.5, 2, 0}}), "harmonic 2.5 is given twice"},
      {with(&SignalSpec::flickers, {{-1, 1, 8, 5, false}}), "flicker: time in s is -1"},
      {with(&SignalSpec::flickers, {{1, 0, 8, 5, false}}), "flicker: duration in s is 0"},
      {with(&SignalSpec::flickers, {{1, 1, 0, 5, true}}), "flicker: frequency in Hz is 0"},
      {with(&SignalSpec::flickers, {{1, 1, 2000, 5, true}}), "flicker: frequency in Hz is 2000"},
      {with(&SignalSpec::flickers, {{1, 1, 8, 101, true}}), "flicker: depth in % is 101"},
      {with(&SignalSpec::tones, {{1, 1, 300, 5, 0, {{-1, 2}}}}), "start of a pulse in s is -1"},
      {with(&SignalSpec::tones, {{1, 1, 300, 5, 0, {{2, 2}}}}), "end of a pulse in s is 2"},
      {with(&SignalSpec::harmonics, {{3, 1, 0}, {5, 1, 0}, {3, 2, 0}}),
       "harmonic 3 is given twice"},
      {with(&SignalSpec::harmonics, {{40, 1, 0}}),
       "harmonic 40 of 50 Hz is 2000 Hz; it must be below half the sample rate of 4000"},
      {with(&SignalSpec::harmonics, {{3, -1, 0}}), "harmonic 3: amplitude in % is -1"},
      {with(&SignalSpec::harmonics, {{3, 1, kNan}}), "harmonic 3: phase"},
      {with(&SignalSpec::amplitude_steps, {{-1, 1, 50}}), "amplitude step: time in s is -1"},
      {with(&SignalSpec::amplitude_steps, {{1, 0, 50}}), "duration in s is 0; it must be above 0"},
      {with(&SignalSpec::amplitude_steps, {{1, kNan, 50}}), "duration in s is nan"},
      {with(&SignalSpec::amplitude_steps, {{1, 1, -5}}), "amplitude step: level in % is -5"},
      {with(&SignalSpec::phase_jumps, {{kInfinity, 5}}), "phase step: time in s is inf"},
      {with(&SignalSpec::phase_jumps, {{1, kNan}}), "phase step: degrees is nan"},
      {with(&SignalSpec::tones, {{-1, 1, 300, 5, 0}}), "tone: time in s is -1"},
      {with(&SignalSpec::tones, {{1, 0, 300, 5, 0}}), "tone: duration in s is 0"},
      {with(&SignalSpec::tones, {{1, 1, 0, 5, 0}}), "tone: frequency in Hz is 0; it must be above"},
      {with(&SignalSpec::tones, {{1, 1, 2000, 5, 0}}), "tone: frequency in Hz is 2000"},
      {with(&SignalSpec::tones, {{1, 1, kNan, 5, 0}}), "tone: frequency in Hz is nan"},
      {with(&SignalSpec::tones, {{1, 1, 300, 101, 0}}), "tone: amplitude in % is 101"},
      {with(&SignalSpec::tones, {{1, 1, 300, 5, kInfinity}}), "tone: phase in degrees is inf"},
      {with(&SignalSpec::dc_offset_pct, 101.0), "DC offset in % is 101"},
      {with(&SignalSpec::initial_phase_deg, kInfinity), "initial phase in degrees is inf"},
  };
  for (const auto& [spec, message] : refused) {
    const auto synthesizer = [&spec = spec] {
      return Synthesizer(constant(50.0, 50.0), spec, 4000);
    };
    EXPECT_THAT(synthesizer, ThrowsMessage<std::invalid_argument>(HasSubstr(message)));
  }
}

TEST(SampleRate, MustBeAMultipleOf1000Hz) {
  for (const std::int64_t rate_hz : {-8000, 0, 999, 1500, 44100, 8001, 1'001'000}) {
    EXPECT_THAT([&] { const Synthesizer synthesizer(constant(50.0, 50.0), {}, rate_hz); },
                ThrowsMessage<std::invalid_argument>(HasSubstr("sample rate")))
        << rate_hz;
  }
  for (const std::int64_t rate_hz : {1000, 4000, 8000, 10000, 1'000'000}) {
    EXPECT_EQ(Synthesizer(constant(50.0, 50.0), {}, rate_hz).sample_rate_hz(), rate_hz);
  }
}

TEST(Signal, RequiresAReference) {
  EXPECT_THROW(Synthesizer(nullptr, {}, 8000), std::invalid_argument);
}

TEST(Signal, RefusesTicksBeforeZero) {
  const Synthesizer synthesizer(constant(50.0, 50.0), {}, 8000);
  EXPECT_THROW(render(synthesizer, -1, 10), std::invalid_argument);
}

}  // namespace
}  // namespace gsbench::waveform
