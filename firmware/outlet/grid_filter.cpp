#include <outlet/grid_filter.hpp>

namespace gs::outlet {
namespace {

// Process noise of every step: 20 µHz of the frequency, 10 µHz/s of q.
constexpr float kDeviationNoise_hz2 = 4.0e-10f;
constexpr float kRocofNoise_hz2_s2 = 1.0e-10f;
// Process noise of the oscillation, whose amplitude and frequency may change: 3e-5 cycles of a and
// b, 3 mrad/s of Ω.
constexpr float kSwingNoise_cycles2 = 9.0e-10f;
constexpr float kSwingOmegaNoise_rad2_s2 = 9.0e-6f;

// Limits of Ω: 0.08 … 1.2 Hz.
constexpr float kLowestOmega_rad_s = kTwoPi * 0.08f;
constexpr float kHighestOmega_rad_s = kTwoPi * 1.2f;
constexpr float kUnknownSwing_hz = 0.1f;    // σ of an unknown oscillation's amplitude
constexpr float kUnknownOmegaPart = 0.15f;  // σ of its Ω, relative

// Standard deviations at the start: of Δf along the line of equilibria, of p and q from that line.
constexpr float kStartDeviation_hz = 0.5f;
constexpr float kStartLoss_mw = 5.0f;
constexpr float kStartRocof_hz_s = 0.002f;

int states_of(const GridFilter& f) {
  return f.with_swing ? kFilterStates : kGridVariables;
}

float& covariance(GridFilter& f, int i, int j) {
  return f.covariance[covariance_index(i, j)];
}

// Columns outside first … last of a row of the transition matrix are zero.
struct Row {
  int first;
  int last;
};
constexpr Row kRows[kFilterStates] = {{0, 3}, {1, 3}, {1, 3}, {3, 3}, {4, 6}, {4, 6}, {6, 6}};

// Moves the state by one step. `to` becomes the transition matrix (Jacobian).
void move_state(const GridStep& step, GridFilter& f, float (&to)[kFilterStates][kFilterStates]) {
  float moved[kGridVariables];
  for (int i = 0; i < kGridVariables; ++i) {
    moved[i] = 0.0f;
    for (int j = kRows[i].first; j <= kRows[i].last; ++j) {
      to[i][j] = step.to[i][j];
      moved[i] += to[i][j] * f.x[j];
    }
  }
  for (int i = 0; i < kGridVariables; ++i) {
    f.x[i] = moved[i];
  }
  f.x[kPhase] -= nearest_whole(f.x[kPhase]);
  if (!f.with_swing) {
    return;
  }
  const float angle_rad = f.x[kSwingOmega] * kReport_s;
  const float cos_angle = cosine(angle_rad);
  const float sin_angle = sine(angle_rad);
  const float swing = cos_angle * f.x[kSwing] + sin_angle * f.x[kSwingAcross];
  const float across = cos_angle * f.x[kSwingAcross] - sin_angle * f.x[kSwing];
  f.x[kSwing] = swing;
  f.x[kSwingAcross] = across;
  to[kSwing][kSwing] = cos_angle;
  to[kSwing][kSwingAcross] = sin_angle;
  to[kSwing][kSwingOmega] = kReport_s * across;
  to[kSwingAcross][kSwing] = -sin_angle;
  to[kSwingAcross][kSwingAcross] = cos_angle;
  to[kSwingAcross][kSwingOmega] = -kReport_s * swing;
  to[kSwingOmega][kSwingOmega] = 1.0f;
}

}  // namespace

void start(const Response& r, GridFilter& f, float phase_cycles, float deviation_hz) {
  f = GridFilter{};
  const float drop = r.gain_hz_per_mw * r.initial_slope_per_s;  // of the ROCOF, per MW
  const float loss_mw = -deviation_hz / r.gain_hz_per_mw;
  f.x[kPhase] = phase_cycles;
  f.x[kDeviation] = deviation_hz;
  f.x[kLoss] = loss_mw;
  f.x[kUnloadedRocof] = drop * loss_mw;
  // Equilibrium: p = −Δf/K and q = K·g0·p, each with a small independent error.
  const float deviation = kStartDeviation_hz * kStartDeviation_hz;
  const float deviation_loss = -deviation / r.gain_hz_per_mw;
  const float loss =
      deviation / (r.gain_hz_per_mw * r.gain_hz_per_mw) + kStartLoss_mw * kStartLoss_mw;
  covariance(f, kDeviation, kDeviation) = deviation;
  covariance(f, kDeviation, kLoss) = deviation_loss;
  covariance(f, kDeviation, kUnloadedRocof) = drop * deviation_loss;
  covariance(f, kLoss, kLoss) = loss;
  covariance(f, kUnloadedRocof, kLoss) = drop * loss;
  covariance(f, kUnloadedRocof, kUnloadedRocof) =
      drop * drop * loss + kStartRocof_hz_s * kStartRocof_hz_s;
}

void add_swing(GridFilter& f, float omega_rad_s) {
  const float amplitude_cycles = kUnknownSwing_hz / omega_rad_s;
  const float omega_sigma = kUnknownOmegaPart * omega_rad_s;
  remove_swing(f);
  f.with_swing = true;
  f.x[kSwingOmega] = omega_rad_s;
  covariance(f, kSwing, kSwing) = amplitude_cycles * amplitude_cycles;
  covariance(f, kSwingAcross, kSwingAcross) = amplitude_cycles * amplitude_cycles;
  covariance(f, kSwingOmega, kSwingOmega) = omega_sigma * omega_sigma;
}

void remove_swing(GridFilter& f) {
  f.with_swing = false;
  for (int i = kSwing; i < kFilterStates; ++i) {
    f.x[i] = 0.0f;
    for (int j = 0; j < kFilterStates; ++j) {
      covariance(f, i, j) = 0.0f;
    }
  }
}

float swing_hz(const GridFilter& f) {
  return f.x[kSwingOmega] * root(f.x[kSwing] * f.x[kSwing] + f.x[kSwingAcross] * f.x[kSwingAcross]);
}

float swing_sigma_hz(const GridFilter& f) {
  return f.x[kSwingOmega] * root(maximum(variance(f, kSwing), variance(f, kSwingAcross)));
}

void predict(const GridStep& step, GridFilter& f, const ProcessNoise& noise) {
  const int n = states_of(f);
  float to[kFilterStates][kFilterStates];
  move_state(step, f, to);
  // P = T·P·Tᵀ; only its upper triangle is computed.
  float half[kFilterStates][kFilterStates];  // T·P
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      float sum = 0.0f;
      for (int k = kRows[i].first; k <= kRows[i].last; ++k) {
        sum += to[i][k] * covariance(f, k, j);
      }
      half[i][j] = sum;
    }
  }
  for (int i = 0; i < n; ++i) {
    for (int j = i; j < n; ++j) {
      float sum = 0.0f;
      for (int k = kRows[j].first; k <= kRows[j].last; ++k) {
        sum += half[i][k] * to[j][k];
      }
      covariance(f, i, j) = sum;
    }
  }
  covariance(f, kPhase, kPhase) += noise.phase;
  covariance(f, kDeviation, kDeviation) += kDeviationNoise_hz2;
  covariance(f, kUnloadedRocof, kUnloadedRocof) += kRocofNoise_hz2_s2;
  covariance(f, kLoss, kLoss) += noise.loss;
  if (f.with_swing) {
    covariance(f, kSwing, kSwing) += kSwingNoise_cycles2;
    covariance(f, kSwingAcross, kSwingAcross) += kSwingNoise_cycles2;
    covariance(f, kSwingOmega, kSwingOmega) += kSwingOmegaNoise_rad2_s2;
  }
}

Innovation correct(GridFilter& f, float phase_cycles, float phase_variance) {
  const int n = states_of(f);
  float innovation = phase_cycles - f.x[kPhase] - f.x[kSwing];
  innovation -= nearest_whole(innovation);
  float with_measured[kFilterStates];  // covariance of each state with z
  for (int i = 0; i < n; ++i) {
    with_measured[i] = covariance(f, i, kPhase) + covariance(f, i, kSwing);
  }
  const float width =
      with_measured[kPhase] + (f.with_swing ? with_measured[kSwing] : 0.0f) + phase_variance;
  const float inverse = 1.0f / width;
  for (int i = 0; i < n; ++i) {
    const float gain = with_measured[i] * inverse;
    f.x[i] += gain * innovation;
    for (int j = i; j < n; ++j) {
      covariance(f, i, j) -= gain * with_measured[j];
    }
    // Rounding must not make a variance negative.
    covariance(f, i, i) = maximum(covariance(f, i, i), 0.0f);
  }
  if (f.with_swing) {
    f.x[kSwingOmega] = bounded(f.x[kSwingOmega], kLowestOmega_rad_s, kHighestOmega_rad_s);
  }
  return {innovation * root(inverse), width / phase_variance};
}

void take_phase(GridFilter& f, float phase_cycles, float phase_variance) {
  f.x[kPhase] = phase_cycles - f.x[kSwing];
  // φ = z − a: the uncertainty of φ is that of a, plus the measurement's.
  for (int i = kDeviation; i < kFilterStates; ++i) {
    covariance(f, kPhase, i) = -covariance(f, kSwing, i);
  }
  covariance(f, kPhase, kPhase) = variance(f, kSwing) + phase_variance;
}

}  // namespace gs::outlet
