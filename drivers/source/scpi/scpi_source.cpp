#include "session.hpp"
#include "settable.hpp"
#include <source_scpi/scpi_source.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>

#include <fmt/format.h>

namespace gsbench::scpi {
namespace {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using source::Played;
using std::chrono::steady_clock;

constexpr std::int64_t kRateStep_hz = 1000;
constexpr std::int64_t kHighestRate_hz = 32000;

constexpr auto kBetweenLooks = std::chrono::milliseconds(5);

double seconds_since(steady_clock::time_point time) {
  return std::chrono::duration<double>(steady_clock::now() - time).count();
}

steady_clock::duration span(double time_s) {
  return std::chrono::duration_cast<steady_clock::duration>(std::chrono::duration<double>(time_s));
}

class ScpiSource final : public source::Source {
 public:
  ScpiSource(Instrument instrument, SourceOptions options)
      : instrument_(std::move(instrument)),
        options_(std::move(options)),
        session_(instrument_, options_.port, options_.baud, options_.channel, interrupt()) {}

  source::Limits limits() const override {
    source::Limits limits;
    limits.name = fmt::format("{} at {}", instrument_.title, options_.port);
    limits.kind = source::Kind::kLoaded;
    const Wiring& wiring = options_.plan.wiring;
    limits.full_scale_pu = full_scale_pu(instrument_, wiring);
    limits.nominal_peak_v = kSqrt2 * wiring.nominal_v;
    if (2.0 * kSqrt2 * wiring.voltage_limit_v < instrument_.amplitude.highest_vpp * wiring.gain) {
      limits.full_scale_is = "the voltage limit";
    }
    for (std::int64_t rate_hz = kRateStep_hz; rate_hz <= kHighestRate_hz; rate_hz += kRateStep_hz) {
      limits.sample_rates_hz.push_back(rate_hz);
    }
    limits.nominal_hz = {50, 60};
    limits.host_clock_uncertainty_s = instrument_.accuracy.trigger_uncertainty_s;
    return limits;
  }

  std::optional<source::HostClock> host_clock() const override {
    if (!triggered_) {
      return std::nullopt;
    }
    const Accuracy& table = instrument_.accuracy;
    return source::HostClock{
        tick_0_, 1.0 / rate_hz_,
        table.trigger_uncertainty_s + triggered_->late_s + 1e-6 * table.clock_ppm * duration_s_};
  }

 protected:
  Result<Played> deviation(const source::Stimulus& stimulus) const override {
    Result<Plan> plan = make_plan(stimulus, instrument_, options_.plan);
    return plan.ok() ? Result<Played>(plan.value().played) : Error{plan.error()};
  }

  Status upload(const source::Progress& progress) override {
    triggered_.reset();
    const Result<Plan> plan = make_plan(stimulus(), instrument_, options_.plan);
    if (!plan.ok()) {
      return Error{plan.error()};
    }
    lead_s_ = plan.value().lead_s;
    duration_s_ = plan.value().duration_s;
    rate_hz_ = static_cast<double>(stimulus().sample_rate_hz());
    return session_.load(plan.value(), progress);
  }

  Status power_up() override {
    Status ready = session_.check_settings();
    if (ready.ok()) {
      ready = session_.switch_on();
    }
    if (!ready.ok()) {
      return ready;
    }
    // From here on a waveform may play, whether or not the trigger is known to have arrived.
    last_trigger_ = steady_clock::now();
    if (Status done = session_.trigger().move_to(triggered_); !done.ok()) {
      return done;
    }
    last_trigger_ = triggered_->sent;
    const auto first_point = triggered_->sent + span(instrument_.accuracy.trigger_latency_s);
    tick_0_ = first_point + span(lead_s_);
    next_question_ = steady_clock::now();
    const auto nominal = first_point + span(options_.plan.rise_s);
    answers_took_s_ = std::max(0.0, seconds_since(nominal));
    return interrupt().wait_until(nominal);
  }

  Status keep_up() override { return steady_clock::now() < tick_0_ ? watch_if_due() : too_late(); }

  Status begin() override {
    if (steady_clock::now() > tick_0_) {
      return too_late();
    }
    return wait_until(tick_0_);
  }

  Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const auto time = tick_0_ + span(static_cast<double>(until_tick) / rate_hz_);
    if (Status waited = wait_until(time); !waited.ok()) {
      return Error{waited.error()};
    }
    const auto reached = static_cast<std::int64_t>(seconds_since(tick_0_) * rate_hz_);
    return std::clamp(reached, until_tick, stimulus().total_ticks());
  }

  Status end() override {
    // Nothing may have been changed up to the last tick.
    Status unchanged = session_.check_playing();
    const source::Interrupt::Ignored ignored(interrupt());
    Status off = switch_off();
    return off.ok() ? unchanged : off;
  }

  Status switch_off() noexcept override {
    try {
      Status off = session_.make_safe(options_.make_safe_s);
      return off.ok() ? off : Error{unknown_state(off.error())};
    } catch (const std::exception& exception) {
      return Error{exception.what()};
    }
  }

 private:
  Status too_late() const {
    return Error{fmt::format(
        "{}: the stimulus began {:.3g} s ago, before the bench was ready: the margin of {} s is "
        "too short; the instrument's answers to the trigger took {:.2g} s of it",
        limits().name, seconds_since(tick_0_), options_.plan.margin_s, answers_took_s_)};
  }

  // Does not wait for the instrument: commands to outlets and the stimulus must not.
  Status watch_if_due() {
    const auto now = steady_clock::now();
    if (!session_.is_asking()) {
      if (now < next_question_) {
        return Done{};
      }
      next_question_ =
          now + span(options_.check_every_s / static_cast<double>(session_.questions()));
    }
    return session_.watch();
  }

  Status wait_until(steady_clock::time_point time) {
    do {
      if (Status same = watch_if_due(); !same.ok()) {
        return same;
      }
      const auto next_look =
          session_.is_asking() ? steady_clock::now() + kBetweenLooks : next_question_;
      if (Status waited = interrupt().wait_until(std::min(time, next_look)); !waited.ok()) {
        return waited;
      }
    } while (steady_clock::now() < time);
    return Done{};
  }

  std::string unknown_state(const std::string& why) const {
    std::string end = "a loaded waveform ends by itself";
    if (last_trigger_) {
      const double left_s = duration_s_ - seconds_since(*last_trigger_);
      end = left_s > 0.0 ? fmt::format("the waveform ends by itself in {:.0f} s", std::ceil(left_s))
                         : std::string("the waveform has ended by itself");
    }
    return fmt::format("{}: output state unknown: {}. Switch the generator off by hand; {}.",
                       limits().name, why, end);
  }

  Instrument instrument_;
  SourceOptions options_;
  Session session_;
  double lead_s_ = 0.0;
  double duration_s_ = 0.0;
  double rate_hz_ = 0.0;
  std::optional<Triggered> triggered_;
  std::optional<steady_clock::time_point> last_trigger_;
  steady_clock::time_point tick_0_;
  steady_clock::time_point next_question_;
  double answers_took_s_ = 0.0;  // of the margin, after the trigger
};

}  // namespace

std::unique_ptr<source::Source> make_scpi_source(Instrument instrument, SourceOptions options) {
  return std::make_unique<ScpiSource>(std::move(instrument), std::move(options));
}

}  // namespace gsbench::scpi
