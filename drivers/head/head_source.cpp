#include "head_source.hpp"

#include <algorithm>

#include <source/fundamental.hpp>

namespace gsbench::head {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

using namespace std::chrono_literals;

constexpr auto kAhead = static_cast<std::int64_t>(kAhead_s * gs::head::kSampleRate_hz);
// A message is not sent for fewer samples, unless a call waits for them.
constexpr std::int64_t kFewest = 32;
constexpr std::int64_t kReturnSamples = 800;  // from the stimulus's last amplitude to nominal
constexpr std::uint16_t kPrefill = 800;
constexpr auto kListened = 10ms;

}  // namespace

source::Limits HeadSource::limits() const {
  source::Limits limits;
  limits.name = "DAC head";
  limits.full_scale_pu = session_->amplitude.full_scale_pu();
  limits.nominal_peak_v = session_->amplitude.nominal_peak_v();
  if (session_->amplitude.voltage_limit_pu() < session_->amplitude.dac_full_scale_pu()) {
    limits.full_scale_is = "the voltage limit";
  }
  limits.sample_rates_hz = {gs::head::kSampleRate_hz};
  limits.nominal_hz = {50, 60};
  return limits;
}

Result<source::Played> HeadSource::deviation(const source::Stimulus& stimulus) const {
  return head::deviation(session_->options, stimulus);
}

std::optional<source::HostClock> HeadSource::host_clock() const {
  const auto round_trip = session_->connection.round_trip();
  if (!session_->tick_0_sample || !round_trip) {
    return std::nullopt;
  }
  constexpr double kSample_s = 1.0 / gs::head::kSampleRate_hz;
  return session_->host_clock.of_ticks(static_cast<double>(*session_->tick_0_sample) * kSample_s,
                                       static_cast<double>(stimulus_end_) * kSample_s, kSample_s,
                                       std::chrono::duration<double>(*round_trip).count());
}

Status HeadSource::upload(const source::Progress&) {
  return session_->connect(interrupt());
}

Status HeadSource::power_up() {
  queued_ = 0;
  // Sample 0 has the phase of tick 0, so that the stimulus can begin after any number of periods.
  nominal_.emplace(stimulus(), 0, 0, 0.0, kRampSamples);
  if (Status armed = session_->arm(interrupt()); !armed.ok()) {
    return armed;
  }
  if (Status filled = fill(); !filled.ok()) {
    return filled;
  }
  if (Status sent = session_->connection.send(gs::head::Play{kPrefill}); !sent.ok()) {
    return sent;
  }
  return stream_until_played(kRampSamples);
}

Status HeadSource::keep_up() {
  Status heard = session_->listen(Clock::now());
  return heard.ok() ? fill() : heard;
}

Status HeadSource::begin() {
  const std::int64_t period =
      source::repeats_after(stimulus().sample_rate_hz(), stimulus().nominal_hz());
  const std::int64_t first = (queued_ + period - 1) / period * period;
  session_->tick_0_sample = first;
  stimulus_end_ = first + stimulus().total_ticks();
  return keep_up();
}

Result<std::int64_t> HeadSource::play_until(std::int64_t until_tick) {
  const Status streamed = stream_until_played(*session_->tick_0_sample + until_tick);
  if (!streamed.ok()) {
    return Error{streamed.error()};
  }
  return ticks_played();
}

std::int64_t HeadSource::ticks_played() const {
  return std::min(session_->samples_played() - *session_->tick_0_sample, stimulus().total_ticks());
}

Status HeadSource::end() {
  if (queued_ < stimulus_end_) {
    end_stimulus_at(std::max(queued_, *session_->tick_0_sample));
  }
  return keep_up();
}

Status HeadSource::stream_until_played(std::int64_t sample) {
  while (session_->samples_played() < sample) {
    if (interrupt().is_set()) {
      return source::Interrupt::error();
    }
    if (Status filled = fill(); !filled.ok()) {
      return filled;
    }
    if (Status heard = session_->listen(Clock::now() + kListened); !heard.ok()) {
      return heard;
    }
  }
  return fill();
}

Status HeadSource::fill() {
  const auto position = static_cast<std::int64_t>(session_->connection.status()->position);
  const std::int64_t until = std::min(position + kAhead, session_->room_until());
  while (until - queued_ >= kFewest) {
    if (interrupt().is_set()) {
      return source::Interrupt::error();
    }
    const auto count = std::min<std::int64_t>(until - queued_,
                                              static_cast<std::int64_t>(gs::head::kLongestSamples));
    if (Status sent = send_samples(count); !sent.ok()) {
      return sent;
    }
  }
  return Done{};
}

Status HeadSource::send_samples(std::int64_t count) {
  gs::head::Samples message;
  message.first_sample = static_cast<std::uint64_t>(queued_);
  message.count = static_cast<std::uint16_t>(count);
  if (Status written = write(count, message.samples); !written.ok()) {
    return written;
  }
  queued_ += count;
  return session_->connection.send(message);
}

Status HeadSource::write(std::int64_t count, std::int16_t* out) {
  const std::int64_t end = queued_ + count;
  const std::int64_t tick_0 = session_->tick_0_sample.value_or(end);
  for (std::int64_t sample = queued_; sample < end;) {
    if (sample >= tick_0 && sample < stimulus_end_) {
      const std::int64_t some = std::min(end, stimulus_end_) - sample;
      const Result<const float*> voltage_pu = samples(sample - tick_0, some);
      if (!voltage_pu.ok()) {
        return Error{voltage_pu.error()};
      }
      out = std::transform(voltage_pu.value(), voltage_pu.value() + some, out, [&](float pu) {
        return session_->amplitude.sample(static_cast<double>(pu));
      });
      sample += some;
      if (sample == stimulus_end_) {
        end_stimulus_at(sample);
      }
    } else {
      *out++ = session_->amplitude.sample(nominal_->at_pu(sample));
      ++sample;
    }
  }
  return Done{};
}

// Nominal voltage from this sample on, in phase with the stimulus before it. The amplitude gets
// there softly.
void HeadSource::end_stimulus_at(std::int64_t sample) {
  stimulus_end_ = sample;
  const std::int64_t tick = sample - *session_->tick_0_sample;
  const std::int64_t last = std::max<std::int64_t>(tick - 1, 0);
  nominal_.emplace(stimulus(), tick, sample, tick > 0 ? stimulus().amplitude_pu(last) : 1.0,
                   kReturnSamples);
}

}  // namespace gsbench::head
