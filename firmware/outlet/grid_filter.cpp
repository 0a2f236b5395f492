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
constexpr float kUnknownSwing_hz = 0.05f;   // σ of an unknown oscillation's amplitude
constexpr float kUnknownOmegaPart = 0.15f;  // σ of its Ω, relative

// Standard deviations at the start: of Δf along the line of equilibria, of p and q from that line.
constexpr float kStartDeviation_hz = 0.5f;
constexpr float kStartLoss_mw = 5.0f;
constexpr float kStartRocof_hz_s = 0.002f;

// What remains of the older terms of the likelihood with each measurement.
constexpr float kKeptLikelihood = 0.99f;

// Places of the covariances with a.
constexpr int kWithSwing[kFilterStates] = {covariance_index(0, kSwing), covariance_index(1, kSwing),
                                           covariance_index(2, kSwing), covariance_index(3, kSwing),
                                           covariance_index(4, kSwing), covariance_index(5, kSwing),
                                           covariance_index(6, kSwing)};

int states_of(const GridFilter& f) {
  return f.with_swing ? kFilterStates : kGridVariables;
}

float& covariance(GridFilter& f, int i, int j) {
  return f.covariance[covariance_index(i, j)];
}

// The transition of a step: of the grid's variables, and of the oscillation's, which depends on Ω.
struct Transition {
  const GridStep& grid;
  float cos_angle;
  float sin_angle;
  float swing_by_omega;
  float across_by_omega;
};

// These multiply a vector, whose elements are kStride apart, by the transition matrix: the elements
// of the grid, and those of the oscillation.
template <int kStride>
inline void move_grid(const Transition& t, float* v) {
  const auto& to = t.grid.to;
  const float deviation = v[kDeviation * kStride];
  const float rocof = v[kUnloadedRocof * kStride];
  const float loss = v[kLoss * kStride];
  // φ and p keep their own value: their elements are 1.
  v[kPhase * kStride] = v[kPhase * kStride] + to[kPhase][kDeviation] * deviation +
                        to[kPhase][kUnloadedRocof] * rocof + to[kPhase][kLoss] * loss;
  v[kDeviation * kStride] = to[kDeviation][kDeviation] * deviation +
                            to[kDeviation][kUnloadedRocof] * rocof + to[kDeviation][kLoss] * loss;
  v[kUnloadedRocof * kStride] = to[kUnloadedRocof][kDeviation] * deviation +
                                to[kUnloadedRocof][kUnloadedRocof] * rocof +
                                to[kUnloadedRocof][kLoss] * loss;
}

template <int kStride>
inline void move_swing(const Transition& t, float* v) {
  const float swing = v[kSwing * kStride];
  const float across = v[kSwingAcross * kStride];
  const float omega = v[kSwingOmega * kStride];
  v[kSwing * kStride] = t.cos_angle * swing + t.sin_angle * across + t.swing_by_omega * omega;
  v[kSwingAcross * kStride] =
      t.cos_angle * across - t.sin_angle * swing + t.across_by_omega * omega;
}

// P = T·P·Tᵀ: moves the rows of P, which is symmetric, then the columns of the result.
template <int kStates>
void move_covariance(const Transition& t, GridFilter& f) {
  float full[kStates][kStates];
  const float* packed = f.covariance;
  for (int i = 0; i < kStates; ++i) {
    for (int j = i; j < kStates; ++j) {
      full[i][j] = packed[j - i];
      full[j][i] = packed[j - i];
    }
    packed += kFilterStates - i;
  }
  for (int i = 0; i < kStates; ++i) {
    move_grid<1>(t, full[i]);
    if (kStates > kSwing) {
      move_swing<1>(t, full[i]);
    }
  }
  float* moved = f.covariance;
  for (int i = 0; i < kStates; ++i) {
    if (i <= kLoss) {  // otherwise all these are below the diagonal
      move_grid<kStates>(t, &full[0][i]);
    }
    if (kStates > kSwing) {
      move_swing<kStates>(t, &full[0][i]);
    }
    for (int j = i; j < kStates; ++j) {
      moved[j - i] = full[j][i];
    }
    moved += kFilterStates - i;
  }
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
  Transition t = {step, 1.0f, 0.0f, 0.0f, 0.0f};
  if (f.with_swing) {
    const float angle_rad = f.x[kSwingOmega] * kReport_s;
    t.cos_angle = cosine(angle_rad);
    t.sin_angle = sine(angle_rad);
    move_grid<1>(t, f.x);
    move_swing<1>(t, f.x);
    t.swing_by_omega = kReport_s * f.x[kSwingAcross];
    t.across_by_omega = -kReport_s * f.x[kSwing];
    move_covariance<kFilterStates>(t, f);
  } else {
    move_grid<1>(t, f.x);
    move_covariance<kGridVariables>(t, f);
  }
  f.x[kPhase] -= nearest_whole(f.x[kPhase]);
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

float correct(GridFilter& f, const PhaseMeasurement& m) {
  if (!m.measured) {
    return 0.0f;
  }
  if (m.after_gap) {
    take_phase(f, m);
    return 0.0f;
  }
  const int n = states_of(f);
  float innovation = m.phase_cycles - f.x[kPhase] - f.x[kSwing];
  innovation -= nearest_whole(innovation);
  float with_measured[kFilterStates];  // covariance of each state with z; φ's are the first row
  for (int i = 0; i < n; ++i) {
    with_measured[i] = f.covariance[i] + (f.with_swing ? f.covariance[kWithSwing[i]] : 0.0f);
  }
  const float width =
      with_measured[kPhase] + (f.with_swing ? with_measured[kSwing] : 0.0f) + m.variance;
  const float inverse = 1.0f / width;
  float* row = f.covariance;
  for (int i = 0; i < n; ++i) {
    const float gain = with_measured[i] * inverse;
    f.x[i] += gain * innovation;
    for (int j = i; j < n; ++j) {
      row[j - i] -= gain * with_measured[j];
    }
    // Rounding must not make a variance negative.
    row[0] = maximum(row[0], 0.0f);
    row += kFilterStates - i;
  }
  if (f.with_swing) {
    f.x[kSwingOmega] = bounded(f.x[kSwingOmega], kLowestOmega_rad_s, kHighestOmega_rad_s);
  }
  const float normalised = innovation * root(inverse);
  f.likelihood = kKeptLikelihood * f.likelihood -
                 0.5f * (normalised * normalised + logarithm(width / m.variance));
  return normalised;
}

void open_loss(const GridStep& step, GridFilter& f, float loss_mw2, int steps) {
  float moved[kGridVariables] = {0.0f, 0.0f, 0.0f, 1.0f};  // by 1 MW that was lost some steps ago
  for (int i = 0; i < steps; ++i) {
    for (int row = 0; row < kGridVariables; ++row) {
      for (int column = row; column < kGridVariables; ++column) {
        covariance(f, row, column) += loss_mw2 * moved[row] * moved[column];
      }
    }
    move_grid<1>({step, 1.0f, 0.0f, 0.0f, 0.0f}, moved);
  }
}

void take_phase(GridFilter& f, const PhaseMeasurement& m) {
  f.x[kPhase] = m.phase_cycles - f.x[kSwing];
  // φ = z − a: the uncertainty of φ is that of a, plus the measurement's.
  for (int i = kDeviation; i < kFilterStates; ++i) {
    covariance(f, kPhase, i) = -covariance(f, kSwing, i);
  }
  covariance(f, kPhase, kPhase) = variance(f, kSwing) + m.variance;
}

}  // namespace gs::outlet
