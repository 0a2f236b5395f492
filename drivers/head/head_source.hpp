// The source of a DAC head. It streams ramp, nominal voltage, stimulus and nominal voltage again,
// one sample of the stream for each tick.
#pragma once

#include "nominal_voltage.hpp"
#include "session.hpp"

#include <cstdint>
#include <memory>
#include <optional>

#include <source/source.hpp>

namespace gsbench::head {

class HeadSource final : public source::Source {
 public:
  explicit HeadSource(std::shared_ptr<Session> session) : session_(std::move(session)) {}

  source::Limits limits() const override;
  std::optional<source::HostClock> host_clock() const override;

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus& stimulus) const override;
  drivers::Status upload(const source::Progress& progress) override;
  drivers::Status power_up() override;
  drivers::Status keep_up() override;
  drivers::Status begin() override;
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override;
  drivers::Status end() override;
  drivers::Status switch_off() noexcept override { return session_->switch_off(); }

 private:
  // Sends samples until the head is kAhead in advance.
  drivers::Status fill();
  drivers::Status send_samples(std::int64_t count);
  // The voltage of samples `queued_` … of the stream.
  drivers::Status write(std::int64_t count, std::int16_t* out);
  drivers::Status stream_until_played(std::int64_t sample);
  std::int64_t ticks_played() const;
  void end_stimulus_at(std::int64_t sample);

  std::shared_ptr<Session> session_;
  std::optional<NominalVoltage> nominal_;  // where there is no stimulus
  std::int64_t queued_ = 0;                // samples sent
  std::int64_t stimulus_end_ = 0;          // sample after its last one; from begin() on
};

}  // namespace gsbench::head
