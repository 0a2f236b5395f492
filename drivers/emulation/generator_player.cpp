#include "generator_player.hpp"

#include <algorithm>
#include <cmath>

namespace gsbench::emulation {

namespace {

constexpr double kPi = 3.14159265358979323846;

// The integral of a square wave from 0 to p cycles.
double square_area(double p, double duty) {
  const double whole = std::floor(p);
  const double part = p - whole;
  return whole * (2 * duty - 1) + (part < duty ? part : 2 * duty - part);
}

// The integral of a ramp, −1 … 1 … −1, from 0 to p cycles. That of a whole cycle is 0.
double ramp_area(double p, double symmetry) {
  const double part = p - std::floor(p);
  if (part < symmetry) {
    return part * part / symmetry - part;
  }
  const double falling = part - symmetry;
  return symmetry < 1 ? falling - falling * falling / (1 - symmetry) : 0.0;
}

// The integral of what is played, −1 … 1, over from … to cycles.
double integral(const Playback& playback, double from, double to) {
  switch (playback.function) {
    case GeneratorFunction::kSine:
      return std::sin(kPi * (from + to)) * std::sin(kPi * (to - from)) / kPi;
    case GeneratorFunction::kSquare:
    case GeneratorFunction::kPulse:
      return square_area(to, playback.duty) - square_area(from, playback.duty);
    case GeneratorFunction::kRamp:
      return ramp_area(to, playback.symmetry) - ramp_area(from, playback.symmetry);
    case GeneratorFunction::kArbitrary:
      return playback.waveform ? playback.waveform->integral(from, to, playback.between) : 0.0;
    // The noise of these instruments has tens of MHz; its mean over a step is small.
    case GeneratorFunction::kNoise:
    case GeneratorFunction::kDc:
      break;
  }
  return 0.0;
}

// Where a burst starts.
double start_value(const Playback& playback) {
  switch (playback.function) {
    case GeneratorFunction::kSine:
      return std::sin(2 * kPi * playback.phase);
    case GeneratorFunction::kSquare:
    case GeneratorFunction::kPulse:
      return playback.phase < playback.duty ? 1.0 : -1.0;
    case GeneratorFunction::kRamp:
      return playback.phase < playback.symmetry
                 ? 2 * playback.phase / playback.symmetry - 1
                 : 1 - 2 * (playback.phase - playback.symmetry) / (1 - playback.symmetry);
    case GeneratorFunction::kArbitrary: {
      if (!playback.waveform) {
        return 0.0;
      }
      const auto points = playback.waveform->points();
      return playback.waveform->value(
          static_cast<std::size_t>(playback.phase * static_cast<double>(points)) % points);
    }
    case GeneratorFunction::kNoise:
    case GeneratorFunction::kDc:
      break;
  }
  return 0.0;
}

}  // namespace

double GeneratorPlayer::Cursor::position(std::int64_t step) const {
  std::int64_t played = step - origin_step;
  if (playback.burst && playback.period_steps > 0) {
    played %= playback.period_steps;
  }
  return origin_cycles + static_cast<double>(played) * playback.cycles_per_step;
}

bool GeneratorPlayer::Cursor::in_burst(std::int64_t step) const {
  return playback.burst && triggered && position(step) < playback.burst_cycles;
}

void GeneratorPlayer::Cursor::apply(const Event& event) {
  switch (event.kind) {
    case Kind::kChange:
      // Goes on where it is, also at another rate.
      if (event.playback.cycles_per_step != playback.cycles_per_step) {
        origin_cycles = position(event.step);
        origin_step = event.step;
      }
      playback = event.playback;
      return;
    case Kind::kRestart:
      playback = event.playback;
      origin_cycles = 0;
      origin_step = event.step;
      triggered = playback.period_steps > 0;
      return;
    case Kind::kTrigger:
      if (playback.burst && playback.period_steps == 0 && !in_burst(event.step)) {
        origin_cycles = 0;
        origin_step = event.step;
        triggered = true;
      }
      return;
    case Kind::kAbort:
      if (playback.burst && playback.period_steps == 0) {
        triggered = false;
      }
      return;
  }
}

void GeneratorPlayer::Cursor::fill(std::int64_t first_step, std::int64_t end_step,
                                   float* volts) const {
  if (!playback.relay_on) {
    std::fill(volts, volts + (end_step - first_step), 0.0F);
    return;
  }
  const double idle = playback.idle.value_or(start_value(playback));
  const double width = playback.cycles_per_step;
  for (std::int64_t step = first_step; step < end_step; ++step) {
    const double from = position(step);
    double played = width;  // of this step
    if (playback.burst) {
      played = triggered ? std::clamp(playback.burst_cycles - from, 0.0, width) : 0.0;
    }
    double mean = idle;
    if (played > 0) {
      const double start = from + playback.phase;
      mean = (integral(playback, start, start + played) + idle * (width - played)) / width;
    }
    *volts++ = static_cast<float>(playback.centre_v + playback.half_v * mean);
  }
}

void GeneratorPlayer::add(Kind kind, const Playback& playback) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Event event{std::max(rendered_end_, time_.now()), kind, playback};
  if (rendered_end_ == std::numeric_limits<std::int64_t>::min()) {
    cursor_.apply(event);
  } else {
    events_.push_back(event);
  }
}

void GeneratorPlayer::change(const Playback& playback, bool restart) {
  add(restart ? Kind::kRestart : Kind::kChange, playback);
}
void GeneratorPlayer::trigger() {
  add(Kind::kTrigger, {});
}
void GeneratorPlayer::abort() {
  add(Kind::kAbort, {});
}

void GeneratorPlayer::render(std::int64_t first_step, std::size_t count, float* volts) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t end = first_step + static_cast<std::int64_t>(count);
  std::int64_t at = first_step;
  while (at < end) {
    while (!events_.empty() && events_.front().step <= at) {
      cursor_.apply(events_.front());
      events_.pop_front();
    }
    const std::int64_t until = events_.empty() ? end : std::min(end, events_.front().step);
    cursor_.fill(at, until, volts + (at - first_step));
    at = until;
  }
  rendered_end_ = std::max(rendered_end_, end);
}

std::int64_t GeneratorPlayer::burst_end() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const std::int64_t now = std::max(rendered_end_, time_.now());
  Cursor cursor = cursor_;
  for (const Event& event : events_) {
    cursor.apply(event);
  }
  if (!cursor.in_burst(now)) {
    return time_.now();
  }
  const double left =
      (cursor.playback.burst_cycles - cursor.position(now)) / cursor.playback.cycles_per_step;
  constexpr auto kNever = std::numeric_limits<std::int64_t>::max();
  return left < 1e15 ? now + static_cast<std::int64_t>(std::ceil(left)) : kNever;
}

}  // namespace gsbench::emulation
