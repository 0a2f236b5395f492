#include <outlet/arithmetic.hpp>
#include <outlet/front_end.hpp>

namespace gs::outlet {
namespace {

// Half of the symmetrical filter, from its middle outwards. Equiripple design for the stop bands in
// the header, weighted 45, 75 and 55 dB. The half's sum is 0.5.
constexpr float kTaps[kFilterLength / 2] = {
    3.63979177e-02f, 3.61150703e-02f, 3.55677001e-02f, 3.47832399e-02f, 3.37857209e-02f,
    3.25880527e-02f, 3.11941467e-02f, 2.96095897e-02f, 2.78538605e-02f, 2.59657007e-02f,
    2.39972390e-02f, 2.19995452e-02f, 2.00080955e-02f, 1.80373303e-02f, 1.60883090e-02f,
    1.41649859e-02f, 1.22889685e-02f, 1.05014951e-02f, 8.85080733e-03f, 7.37011847e-03f,
    6.06075355e-03f, 4.89265545e-03f, 3.82504817e-03f, 2.83717322e-03f, 1.95039647e-03f,
    1.22504270e-03f, 7.28432216e-04f, 1.31260482e-03f};

constexpr float kTableScale = 16384.0f;

std::int32_t greatest_common_divisor(std::int32_t a, std::int32_t b) {
  while (b != 0) {
    const std::int32_t rest = a % b;
    a = b;
    b = rest;
  }
  return a;
}

std::int16_t rounded(float x) {
  return static_cast<std::int16_t>(x + (x < 0.0f ? -0.5f : 0.5f));
}

// Adds `count` samples, mixed with the table from `at` on, upwards (kStep 1) or downwards (kStep
// −1). The second half of the period is the first one downwards, with the sine's sign changed.
template <int kStep>
void mix(const FrontEndConfig& config, FrontEndState& state, const std::int16_t* samples,
         std::size_t at, std::size_t count) {
  const std::int16_t* cosine = config.cosine + at;
  const std::int16_t* sine = config.sine + at;
  std::int64_t in_phase = 0;
  std::int64_t quadrature = 0;
  std::int64_t squares = 0;
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(count); ++i) {
    const std::int32_t x = samples[i];
    in_phase += x * cosine[kStep * i];
    quadrature += x * sine[kStep * i];
    squares += x * x;
  }
  state.in_phase += in_phase;
  state.quadrature += kStep * quadrature;
  state.squares += squares;
}

void close_millisecond(const FrontEndConfig& config, FrontEndState& state) {
  const float scale = config.pu_per_count / static_cast<float>(config.samples_per_ms);
  // × 2: mixing a real signal leaves half its amplitude at the difference frequency.
  const float mixed = 2.0f * scale / kTableScale;
  state.ring_in_phase[state.head] = static_cast<float>(state.in_phase) * mixed;
  state.ring_quadrature[state.head] = static_cast<float>(state.quadrature) * mixed;
  state.ring_squares[state.head] = static_cast<float>(state.squares) * scale * config.pu_per_count;
  state.in_phase = 0;
  state.quadrature = 0;
  state.squares = 0;
  state.samples_in_ms = 0;
  state.head = static_cast<std::uint8_t>(state.head + 1 == kFilterLength ? 0 : state.head + 1);
  if (state.filled < kFilterLength) {
    ++state.filled;
  }
  ++state.subsum;
}

}  // namespace

bool make_front_end(const Hardware& hardware, FrontEndConfig& config) {
  const bool rate_supported = hardware.sample_rate_hz >= 1000 &&
                              hardware.sample_rate_hz <= kMaxSampleRate_hz &&
                              hardware.sample_rate_hz % 1000 == 0;
  const bool nominal_supported = hardware.nominal_hz == 50 || hardware.nominal_hz == 60;
  if (!rate_supported || !nominal_supported || !(hardware.counts_per_pu >= 1.0f) ||
      !(hardware.counts_per_pu <= 32767.0f)) {
    return false;
  }
  const std::int32_t divisor =
      greatest_common_divisor(hardware.sample_rate_hz, hardware.nominal_hz);
  const std::int32_t length = hardware.sample_rate_hz / divisor;
  const std::int32_t turns = hardware.nominal_hz / divisor;
  config.samples_per_ms = static_cast<std::uint16_t>(hardware.sample_rate_hz / 1000);
  config.table_length = static_cast<std::uint16_t>(length);
  config.pu_per_count = 1.0f / hardware.counts_per_pu;
  for (std::int32_t n = 0; n <= length / 2; ++n) {
    std::int32_t step = (n * turns) % length;
    step = 2 * step > length ? step - length : step;
    const float angle = kTwoPi * static_cast<float>(step) / static_cast<float>(length);
    config.cosine[n] = rounded(kTableScale * cosine(angle));
    // Conjugate: mixing down multiplies by e^(−jωt).
    config.sine[n] = rounded(-kTableScale * sine(angle));
  }
  return true;
}

std::size_t feed(const FrontEndConfig& config, FrontEndState& state, const std::int16_t* samples,
                 std::size_t count, bool& ready) {
  if (state.subsum == kSubsumsPerReport) {
    state.subsum = 0;
  }
  std::size_t taken = 0;
  while (taken < count && state.subsum < kSubsumsPerReport) {
    const std::size_t length = config.table_length;
    const std::size_t index = state.table_index;
    const bool mirrored = index > length / 2;
    std::size_t run = static_cast<std::size_t>(config.samples_per_ms) - state.samples_in_ms;
    const std::size_t to_turn = mirrored ? length - index : length / 2 + 1 - index;
    run = run < to_turn ? run : to_turn;
    run = run < count - taken ? run : count - taken;
    if (mirrored) {
      mix<-1>(config, state, samples + taken, length - index, run);
    } else {
      mix<1>(config, state, samples + taken, index, run);
    }
    taken += run;
    state.table_index = static_cast<std::uint16_t>(index + run == length ? 0 : index + run);
    state.samples_in_ms = static_cast<std::uint16_t>(state.samples_in_ms + run);
    if (state.samples_in_ms == config.samples_per_ms) {
      close_millisecond(config, state);
    }
  }
  ready = state.subsum == kSubsumsPerReport;
  return taken;
}

Phasor phasor(const FrontEndState& state) {
  Phasor out;
  float squares = 0.0f;
  int newest = state.head;
  for (int age = 0; age < kFilterLength; ++age) {
    newest = newest == 0 ? kFilterLength - 1 : newest - 1;
    const int half = kFilterLength / 2;
    const float tap = kTaps[age < half ? half - 1 - age : age - half];
    out.in_phase += tap * state.ring_in_phase[newest];
    out.quadrature += tap * state.ring_quadrature[newest];
    if (age < kVoltageWindow_ms) {
      squares += state.ring_squares[newest];
    }
  }
  // RMS per unit of nominal RMS: the nominal amplitude's square is twice its mean square.
  out.voltage_pu = root(2.0f * squares / static_cast<float>(kVoltageWindow_ms));
  out.complete = state.filled >= kFilterLength;
  return out;
}

}  // namespace gs::outlet
