// A source that plays nothing, to test what reads a source's clock.
#pragma once

#include <optional>

#include <source/source.hpp>

namespace gsbench::test {

class ClockedSource final : public source::Source {
 public:
  source::Limits limits() const override { return known; }
  std::optional<source::HostClock> host_clock() const override { return clock; }

  source::Limits known;
  std::optional<source::HostClock> clock;

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus&) const override {
    return source::Played{};
  }
  drivers::Status power_up() override { return drivers::Done{}; }
  drivers::Status begin() override { return drivers::Done{}; }
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override { return until_tick; }
  drivers::Status switch_off() noexcept override { return drivers::Done{}; }
};

}  // namespace gsbench::test
