#include <outlet/arithmetic.hpp>
#include <outlet/tracker.hpp>

namespace gs::outlet {
namespace {

// The phase gate is wider than the setting by this many predicted standard deviations. That is
// little for a settled filter, and much after a phase step, when the frequency may have changed.
constexpr float kSigmasAllowed = 5.0f;
// The phase gate is wider while coasting: no correction is made then, and after 0.1 s at 10 Hz/s
// the phase error grows by 0.1 rad per report. Only a larger change counts as another phase step.
constexpr float kCoastingFactor = 8.0f;
// Reports within the gate that end coasting. The front end's window of 56 ms spreads a step over
// four reports.
constexpr std::uint8_t kReportsToClear = 3;
// After this many reports without a measurement, the kept frequency is no longer usable.
constexpr std::uint8_t kLongestHold = 16;
constexpr std::uint16_t kReportsToSettle = 16;
// Largest standard deviation of a frequency that is reported as valid, 20 mHz: ten times that of
// the settled filter at 1 % noise.
constexpr float kLargestValidSigma_rad_s = kTwoPi * 0.020f;

// Bounds of the state, beyond those of any grid: ±15 Hz, ±30 Hz/s.
constexpr float kLargestOmega_rad_s = kTwoPi * 15.0f;
constexpr float kLargestAlpha_rad_s2 = kTwoPi * 30.0f;

enum { kPP, kPW, kPA, kWW, kWA, kAA };

bool beyond(float x, float limit) {
  return x > limit || x < -limit;
}

// White noise rotates a shorter phasor further. Factor relative to nominal amplitude; at least 1.
float phase_noise_factor(const TrackerState& s) {
  return s.amplitude < 1.0f ? 1.0f / s.amplitude : 1.0f;
}

float phase_variance(const TrackerSettings& settings, const TrackerState& s) {
  const float sigma_rad = settings.phase_noise_rad * phase_noise_factor(s);
  return sigma_rad * sigma_rad;
}

void predict(const TrackerSettings& settings, TrackerState& s) {
  constexpr float t = kReport_s;
  constexpr float half_t2 = 0.5f * t * t;
  s.phase_rad = wrapped(s.phase_rad + s.omega_rad_s * t + s.alpha_rad_s2 * half_t2);
  s.omega_rad_s += s.alpha_rad_s2 * t;

  // P = F·P·Fᵀ + Q with F = [1 t t²/2; 0 1 t; 0 0 1].
  float* p = s.covariance;
  const float pw = p[kPW] + t * p[kWW] + half_t2 * p[kWA];
  const float pa = p[kPA] + t * p[kWA] + half_t2 * p[kAA];
  const float wa = p[kWA] + t * p[kAA];
  p[kPP] = p[kPP] + t * p[kPW] + half_t2 * p[kPA] + t * pw + half_t2 * pa;
  p[kPW] = pw + t * pa;
  p[kPA] = pa;
  p[kWW] = p[kWW] + t * p[kWA] + t * wa;
  p[kWA] = wa;

  const float q = settings.jerk_rad_s3_per_sqrt_hz * settings.jerk_rad_s3_per_sqrt_hz;
  p[kPP] += q * (t * t * t * t * t / 20.0f);
  p[kPW] += q * (t * t * t * t / 8.0f);
  p[kPA] += q * (t * t * t / 6.0f);
  p[kWW] += q * (t * t * t / 3.0f);
  p[kWA] += q * (half_t2);
  p[kAA] += q * t;
}

void correct(const TrackerSettings& settings, TrackerState& s, float innovation_rad,
             float innovation_amplitude) {
  float* p = s.covariance;
  const float r = phase_variance(settings, s);
  const float inverse = 1.0f / (p[kPP] + r);
  const float gain_phase = p[kPP] * inverse;
  const float gain_omega = p[kPW] * inverse;
  const float gain_alpha = p[kPA] * inverse;
  s.phase_rad = wrapped(s.phase_rad + gain_phase * innovation_rad);
  s.omega_rad_s = bounded(s.omega_rad_s + gain_omega * innovation_rad, -kLargestOmega_rad_s,
                          kLargestOmega_rad_s);
  s.alpha_rad_s2 = bounded(s.alpha_rad_s2 + gain_alpha * innovation_rad, -kLargestAlpha_rad_s2,
                           kLargestAlpha_rad_s2);
  // (1 − gain)·p, written so that the diagonal cannot become negative.
  const float keep = r * inverse;
  s.last_innovation_rad = keep * innovation_rad;
  p[kAA] = maximum(p[kAA] - gain_alpha * p[kPA], 0.0f);
  p[kWA] = p[kWA] - gain_omega * p[kPA];
  p[kWW] = maximum(p[kWW] - gain_omega * p[kPW], 0.0f);
  p[kPA] = keep * p[kPA];
  p[kPW] = keep * p[kPW];
  p[kPP] = keep * p[kPP];

  constexpr float kAmplitudeGain = 0.4f;
  s.amplitude += kAmplitudeGain * innovation_amplitude * s.amplitude;
  s.last_innovation_amplitude = (1.0f - kAmplitudeGain) * innovation_amplitude;
}

// Takes phase and amplitude from the phasor; keeps the frequency.
void take_phase(TrackerState& s, const Phasor& z, float amplitude) {
  s.phase_rad = angle_of(z.quadrature, z.in_phase);
  s.amplitude = amplitude;
  s.last_innovation_rad = 0.0f;
  s.last_innovation_amplitude = 0.0f;
  s.coasting = false;
  s.quiet = 0;
}

void set_covariance(const TrackerSettings& settings, TrackerState& s, float omega_sigma_rad_s,
                    float alpha_sigma_rad_s2) {
  for (float& entry : s.covariance) {
    entry = 0.0f;
  }
  s.covariance[kPP] = phase_variance(settings, s);
  s.covariance[kWW] = omega_sigma_rad_s * omega_sigma_rad_s;
  s.covariance[kAA] = alpha_sigma_rad_s2 * alpha_sigma_rad_s2;
}

void acquire(const TrackerSettings& settings, TrackerState& s, const Phasor& z, float amplitude) {
  take_phase(s, z, amplitude);
  s.omega_rad_s = 0.0f;
  s.alpha_rad_s2 = 0.0f;
  // Standard deviations of an unknown frequency and ROCOF: 5 Hz, 2 Hz/s.
  set_covariance(settings, s, kTwoPi * 5.0f, kTwoPi * 2.0f);
  s.age = 0;
  s.held = 0;
}

// One report of coasting over a phase or amplitude step.
void coast(const TrackerSettings& settings, TrackerState& s, const Phasor& z, float amplitude,
           bool outside_gate) {
  s.coasting = true;
  s.quiet = outside_gate ? std::uint8_t{0} : static_cast<std::uint8_t>(s.quiet + 1);
  ++s.held;
  if (s.held >= kLongestHold) {
    acquire(settings, s, z, amplitude);
  } else if (s.quiet >= kReportsToClear) {
    take_phase(s, z, amplitude);
    // Standard deviations of what changed while coasting: 0.25 Hz, 3 Hz/s.
    set_covariance(settings, s, kTwoPi * 0.25f, kTwoPi * 3.0f);
  }
}

// True if either innovation changed by more than its gate since the last report.
bool innovations_outside_gate(const TrackerSettings& settings, const TrackerState& s,
                              float innovation_rad, float innovation_amplitude) {
  const float gate_rad = settings.innovation_gate_rad * phase_noise_factor(s);
  const float limit_rad =
      gate_rad * (s.coasting ? kCoastingFactor : 1.0f) + kSigmasAllowed * root(s.covariance[kPP]);
  return beyond(innovation_rad - s.last_innovation_rad, limit_rad) ||
         beyond(innovation_amplitude - s.last_innovation_amplitude,
                settings.innovation_gate_amplitude);
}

Measurement report(float nominal_hz, const TrackerState& s, const Phasor& z, Validity validity) {
  Measurement m;
  m.voltage_pu = z.voltage_pu;
  m.validity = validity;
  if (validity == Validity::kInvalid) {
    m.frequency_hz = kNotANumber;
    m.rocof_hz_s = kNotANumber;
  } else {
    m.frequency_hz = nominal_hz + s.omega_rad_s * (1.0f / kTwoPi);
    m.rocof_hz_s = s.alpha_rad_s2 * (1.0f / kTwoPi);
  }
  return m;
}

}  // namespace

Measurement track(const TrackerSettings& settings, float nominal_hz, TrackerState& s,
                  const Phasor& z) {
  const float amplitude = root(z.in_phase * z.in_phase + z.quadrature * z.quadrature);
  const float alive_above = s.dead ? 1.5f * settings.dead_bus_pu : settings.dead_bus_pu;
  if (!z.complete || !(amplitude >= alive_above) || !(z.voltage_pu >= alive_above)) {
    s.dead = true;
    return report(nominal_hz, s, z, Validity::kInvalid);
  }
  if (s.dead) {
    s.dead = false;
    acquire(settings, s, z, amplitude);
    return report(nominal_hz, s, z, Validity::kInvalid);
  }

  predict(settings, s);
  const float cos_phase = cosine(s.phase_rad);
  const float sin_phase = sine(s.phase_rad);
  const float along = z.in_phase * cos_phase + z.quadrature * sin_phase;
  const float across = z.quadrature * cos_phase - z.in_phase * sin_phase;
  const bool settling = s.age < kReportsToSettle;
  // Phase innovation as an angle and amplitude innovation as a ratio: both stay meaningful when the
  // predicted phasor is far off, as while settling or when the voltage returns.
  const float innovation_rad = angle_of(across, along);
  const float innovation_amplitude = amplitude / s.amplitude - 1.0f;

  const bool outside_gate =
      innovations_outside_gate(settings, s, innovation_rad, innovation_amplitude);
  if (outside_gate && settling) {
    acquire(settings, s, z, amplitude);
    return report(nominal_hz, s, z, Validity::kInvalid);
  }
  if (outside_gate || s.coasting) {
    s.last_innovation_rad = innovation_rad;
    s.last_innovation_amplitude = innovation_amplitude;
    coast(settings, s, z, amplitude, outside_gate);
    return report(nominal_hz, s, z, Validity::kHeld);
  }
  correct(settings, s, innovation_rad, innovation_amplitude);
  if (settling) {
    ++s.age;
    s.held = 0;
    return report(nominal_hz, s, z, Validity::kInvalid);
  }
  // After coasting, the frequency is valid only once its uncertainty is small again.
  if (s.covariance[kWW] > kLargestValidSigma_rad_s * kLargestValidSigma_rad_s) {
    return report(nominal_hz, s, z, Validity::kHeld);
  }
  s.held = 0;
  return report(nominal_hz, s, z, Validity::kValid);
}

}  // namespace gs::outlet
