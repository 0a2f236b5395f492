#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include <emulation/terminal_sense.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

// The mean square over 160 samples with noise of 1 % has a standard deviation of 0.0011 pu². It
// falls by 14 pu²/s in a dip to 85 %, so this is 0.08 ms.
constexpr double kDipUncertainty_s = 0.0003;
constexpr double kPatience_s = 1.0;
// Below this mean square (nominal is 0.5) a voltage is rising or off.
constexpr double kLeastSquare_pu2 = 0.05;

// Where the mean square of these samples falls below `ratio`, in samples.
std::optional<double> dip_of(const std::vector<float>& samples, std::int64_t period, double ratio) {
  DipFinder finder(period, ratio);
  for (const float sample : samples) {
    if (const auto found = finder.take(static_cast<double>(sample))) {
      return found;
    }
  }
  return std::nullopt;
}

// The ratio for a dip to `level`, if it is found: one at which the mean square falls fast. It falls
// as the square of the voltage, so fast at a peak and not at all at a zero crossing. A dip that
// starts at a zero crossing has a quarter of its effect at the next peak, one that starts at a peak
// half of its effect half a period later.
std::optional<double> steepest_ratio(const std::vector<float>& samples, std::int64_t period,
                                     double level) {
  constexpr double kEffects[] = {0.25, 0.5};
  constexpr double kBeside = 0.02;  // of the effect
  std::optional<double> best_ratio;
  double least_samples = std::numeric_limits<double>::infinity();
  for (const double effect : kEffects) {
    const auto ratio = [&](double part) { return 1.0 - part * (1.0 - level * level); };
    const auto from = dip_of(samples, period, ratio(effect - kBeside));
    const auto to = dip_of(samples, period, ratio(effect + kBeside));
    if (from && to && *to - *from < least_samples) {
      least_samples = *to - *from;
      best_ratio = ratio(effect);
    }
  }
  return best_ratio;
}

}  // namespace

DipFinder::DipFinder(std::int64_t samples_per_period, double ratio)
    : period_(samples_per_period),
      ratio_(ratio),
      squares_(static_cast<std::size_t>(4 * samples_per_period)) {}

std::optional<double> DipFinder::take(double voltage) {
  const auto at = [this](std::int64_t sample) -> double& {
    return squares_[static_cast<std::size_t>(sample % (4 * period_))];
  };
  before_ -= at(taken_);  // 0 until the ring is full
  if (taken_ >= period_) {
    before_ += at(taken_ - period_);
    recent_ -= at(taken_ - period_);
  }
  at(taken_) = voltage * voltage;
  recent_ += voltage * voltage;
  ++taken_;
  const double excess = recent_ - ratio_ * before_ / 3.0;
  const double last = std::exchange(last_excess_, excess);
  if (taken_ <= 4 * period_ || excess >= 0.0 ||
      before_ < 3.0 * kLeastSquare_pu2 * static_cast<double>(period_)) {
    return std::nullopt;
  }
  return static_cast<double>(taken_) - (last > 0.0 ? excess / (excess - last) : 0.0);
}

TerminalSense::TerminalSense(const source::Stimulus& stimulus, const source::Source& source,
                             double clock_ppm, const TrueTime& time)
    : source_(source),
      time_(time),
      rate_hz_(static_cast<double>(stimulus.sample_rate_hz())),
      steps_per_tick_(TrueTime::kRate_hz / (rate_hz_ * (1.0 + 1e-6 * clock_ppm))) {
  const double steady_pu = stimulus.amplitude_pu(0);
  std::int64_t dip = 0;
  while (dip < stimulus.total_ticks() && stimulus.amplitude_pu(dip) > 0.99 * steady_pu) {
    ++dip;
  }
  if (dip == stimulus.total_ticks()) {
    return;
  }
  const double level = stimulus.amplitude_pu(dip) / steady_pu;
  const std::int64_t period_ticks = stimulus.sample_rate_hz() / stimulus.nominal_hz();
  std::vector<float> samples(
      static_cast<std::size_t>(std::min(dip + 2 * period_ticks, stimulus.total_ticks())));
  stimulus.render(0, samples.size(), samples.data());
  const std::optional<double> ratio = steepest_ratio(samples, period_ticks, level);
  if (const auto found = ratio ? dip_of(samples, period_ticks, *ratio) : std::nullopt) {
    // A tick is an instant, a step an interval: sample n stands for n − ½ … n + ½.
    dip_ticks_ = *found - 0.5;
    aligned_by_dips_ = true;
    finder_.emplace(TrueTime::kRate_hz / stimulus.nominal_hz(), *ratio);
  }
}

void TerminalSense::seen(const float* voltage_pu, std::size_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  for (std::size_t i = 0; i < count && finder_ && !dip_steps_; ++i) {
    dip_steps_ = finder_->take(static_cast<double>(voltage_pu[i]));
  }
}

void TerminalSense::moved(std::size_t channel, std::int64_t step, bool closed) {
  const std::lock_guard<std::mutex> lock(mutex_);
  edges_.push_back({channel, step, closed});
}

relay::Alignment TerminalSense::alignment() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  relay::Alignment alignment;
  alignment.counts_per_tick = steps_per_tick_;
  // Half a tick for the edge, half for the outlet's sample at which the coil changed.
  alignment.uncertainty_ticks = 1.0;
  alignment.uncertainty_between_ticks = 1.5;
  const auto clock = source_.host_clock();
  if (finder_) {
    alignment.count_at_tick_0 = dip_steps_.value_or(0.0) - dip_ticks_ * steps_per_tick_;
    alignment.uncertainty_ticks += kDipUncertainty_s * rate_hz_;
  } else if (clock) {
    alignment.count_at_tick_0 =
        TrueTime::kRate_hz * std::chrono::duration<double>(clock->tick_0 - time_.start).count();
    alignment.uncertainty_ticks += clock->uncertainty_s * rate_hz_;
  } else {
    alignment.uncertainty_ticks += source_.limits().host_clock_uncertainty_s * rate_hz_;
  }
  return alignment;
}

std::string TerminalSense::not_known_yet() const {
  return aligned_by_dips_
             ? ""
             : "how late the source starts and how far its clock drifts from this machine's";
}

std::optional<std::int64_t> TerminalSense::count_at(
    std::chrono::steady_clock::time_point time) const {
  return std::llround(TrueTime::kRate_hz *
                      std::chrono::duration<double>(time - time_.start).count());
}

Status TerminalSense::poll(std::vector<relay::Edge>& edges) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto clock = source_.host_clock();
  if (finder_ ? dip_steps_.has_value() : clock.has_value()) {
    edges.insert(edges.end(), edges_.begin(), edges_.end());
    edges_.clear();
    return Done{};
  }
  const double since_0_s =
      clock
          ? std::chrono::duration<double>(std::chrono::steady_clock::now() - clock->tick_0).count()
          : 0.0;
  if (clock && since_0_s > dip_ticks_ * clock->tick_s + clock->uncertainty_s + kPatience_s) {
    return Error{
        "emulated terminals: the first dip of the stimulus was not seen at the outlets, so the "
        "contacts' times cannot be aligned"};
  }
  return Done{};
}

}  // namespace gsbench::emulation
