#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <models/noise.hpp>
#include <source/source.hpp>

namespace gsbench::source {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr std::int64_t kScannedAtOnce = 4096;

std::string level(const Limits& limits, double voltage_pu) {
  return limits.nominal_peak_v > 0.0 ? fmt::format("{:.5g} pu ({:.1f} V peak at the outlets)",
                                                   voltage_pu, voltage_pu * limits.nominal_peak_v)
                                     : fmt::format("{:.5g} pu", voltage_pu);
}

Error beyond_full_scale(const Limits& limits, const Stimulus& stimulus, std::int64_t tick,
                        double voltage_pu) {
  const double t_s = static_cast<double>(tick) / static_cast<double>(stimulus.sample_rate_hz());
  const bool noisy = !limits.noise_per_outlet && stimulus.noise().rms_pu > 0.0F;
  return {fmt::format("{}: {} at {:.4f} s{} is beyond its full scale of {}{}", limits.name,
                      level(limits, voltage_pu), t_s, noisy ? ", noise included," : "",
                      level(limits, limits.full_scale_pu),
                      limits.full_scale_is.empty() ? "" : ", " + limits.full_scale_is)};
}

Status render(const Limits& limits, const Stimulus& stimulus, std::int64_t first_tick,
              std::int64_t count, std::vector<float>& out) {
  out.resize(static_cast<std::size_t>(count));
  stimulus.render(first_tick, out.size(), out.data());
  if (const Noise noise = stimulus.noise(); !limits.noise_per_outlet && noise.rms_pu > 0.0F) {
    models::add_gaussian({noise.seed, models::kSourceNoise, 0},
                         static_cast<std::uint64_t>(first_tick), out.size(), noise.rms_pu,
                         out.data());
  }
  const auto full_scale = static_cast<float>(limits.full_scale_pu);
  const auto beyond = std::find_if(out.begin(), out.end(), [full_scale](float pu) {
    return !(std::fabs(pu) <= full_scale);  // true for NaN
  });
  if (beyond != out.end()) {
    return beyond_full_scale(limits, stimulus, first_tick + (beyond - out.begin()),
                             static_cast<double>(*beyond));
  }
  return Done{};
}

template <class Value>
Status one_of(const Limits& limits, const char* what, Value value, const std::vector<Value>& ones) {
  if (std::find(ones.begin(), ones.end(), value) != ones.end()) {
    return Done{};
  }
  std::string list;
  for (const Value one : ones) {
    list += fmt::format("{}{}", list.empty() ? "" : ", ", one);
  }
  return Error{fmt::format("{}: a {} of {} Hz is not supported; supported: {} Hz", limits.name,
                           what, value, list)};
}

Status within(const Limits& limits, const Stimulus& stimulus) {
  const std::int64_t rate_hz = stimulus.sample_rate_hz();
  const std::int64_t ticks = stimulus.total_ticks();
  Status served = one_of(limits, "sample rate", rate_hz, limits.sample_rates_hz);
  if (served.ok()) {
    served = one_of(limits, "nominal frequency", stimulus.nominal_hz(), limits.nominal_hz);
  }
  if (!served.ok()) {
    return served;
  }
  const double duration_s = static_cast<double>(ticks) / static_cast<double>(rate_hz);
  if (ticks < 2 || duration_s > limits.longest_s) {
    return Error{
        fmt::format("{}: cannot play a stimulus of {} ticks ({} s): at least 2 ticks and "
                    "at most {} s are possible",
                    limits.name, ticks, duration_s, limits.longest_s)};
  }
  return Done{};
}

Status within_full_scale(const Limits& limits, const Stimulus& stimulus) {
  const std::int64_t ticks = stimulus.total_ticks();
  std::vector<float> scanned;
  for (std::int64_t tick = 0; tick < ticks; tick += kScannedAtOnce) {
    Status rendered =
        render(limits, stimulus, tick, std::min(kScannedAtOnce, ticks - tick), scanned);
    if (!rendered.ok()) {
      return rendered;
    }
  }
  return Done{};
}

}  // namespace

Status Source::expect(const char* call, State needed) {
  interrupt_.begin_call();
  if (state_ == needed) {
    return Done{};
  }
  static const char* const kWords[] = {"off",     "prepared", "energised",
                                       "playing", "stopped",  "failed"};
  return Error{fmt::format("{}: cannot {} while {}: it must be {}", limits().name, call,
                           kWords[static_cast<std::size_t>(state_)],
                           kWords[static_cast<std::size_t>(needed)])};
}

Status Source::ready_to(const char* call, State needed) {
  Status expected = expect(call, needed);
  return expected.ok() && interrupt_.is_set()
             ? Error{fmt::format("{}: {}", limits().name, Interrupt::error().message)}
             : expected;
}

Status Source::enter(State next, Status answer) {
  state_ = answer.ok() ? next : State::kFailed;
  return answer;
}

Result<Played> Source::check(const Stimulus& stimulus) const {
  Status playable = within(limits(), stimulus);
  if (playable.ok()) {
    playable = within_full_scale(limits(), stimulus);
  }
  // Drivers compute the deviation of samples within full scale only.
  return playable.ok() ? deviation(stimulus) : Error{playable.error()};
}

Result<Played> Source::preview(const Stimulus& stimulus) const {
  if (const Status possible = within(limits(), stimulus); !possible.ok()) {
    return Error{possible.error()};
  }
  return deviation(stimulus);
}

Result<Played> Source::prepare(const Stimulus& stimulus, const Progress& progress) {
  if (const Status ready = ready_to("prepare", State::kOff); !ready.ok()) {
    return Error{ready.error()};
  }
  Result<Played> played = limits().kind == Kind::kStreamed ? preview(stimulus) : check(stimulus);
  if (!played.ok()) {
    return played;
  }
  stimulus_ = &stimulus;
  limits_ = limits();
  tick_ = 0;
  if (const Status uploaded = enter(State::kPrepared, upload(progress)); !uploaded.ok()) {
    return Error{uploaded.error()};
  }
  return played;
}

Status Source::energise() {
  Status ready = ready_to("energise", State::kPrepared);
  return ready.ok() ? enter(State::kEnergised, power_up()) : ready;
}

Status Source::hold() {
  if (state_ == State::kStopped) {
    return limits_.kind == Kind::kStreamed ? enter(State::kStopped, keep_up()) : Done{};
  }
  Status ready = ready_to("hold", State::kEnergised);
  return ready.ok() ? enter(State::kEnergised, keep_up()) : ready;
}

Status Source::start() {
  Status ready = ready_to("start", State::kEnergised);
  return ready.ok() ? enter(State::kPlaying, begin()) : ready;
}

Result<std::int64_t> Source::advance(std::int64_t until_tick) {
  if (const Status ready = ready_to("advance", State::kPlaying); !ready.ok()) {
    return Error{ready.error()};
  }
  const std::int64_t end_tick = stimulus_->total_ticks();
  if (until_tick <= tick_ || until_tick > end_tick) {
    return Error{fmt::format("{}: cannot advance to tick {}: it is at tick {} of {}", limits_.name,
                             until_tick, tick_, end_tick)};
  }
  Result<std::int64_t> played = play_until(until_tick);
  if (!played.ok()) {
    state_ = State::kFailed;
    return played;
  }
  if (played.value() < until_tick || played.value() > end_tick) {
    state_ = State::kFailed;
    return Error{fmt::format("{}: was to advance to tick {} of {} but is at tick {}", limits_.name,
                             until_tick, end_tick, played.value())};
  }
  tick_ = played.value();
  return played;
}

Status Source::stop() {
  Status ready = expect("stop", State::kPlaying);
  return ready.ok() ? enter(State::kStopped, end()) : ready;
}

Status Source::make_safe() noexcept {
  stimulus_ = nullptr;
  interrupt_.begin_call();
  const Interrupt::Ignored ignored(interrupt_);
  return enter(State::kOff, switch_off());
}

Result<const float*> Source::samples(std::int64_t first_tick, std::int64_t count) {
  if (const Status rendered = render(limits_, *stimulus_, first_tick, count, samples_);
      !rendered.ok()) {
    return Error{rendered.error()};
  }
  return static_cast<const float*>(samples_.data());
}

}  // namespace gsbench::source
