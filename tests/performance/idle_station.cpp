#include "idle_station.hpp"

#include <outlet/settings.hpp>

namespace gsbench::performance {
namespace {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

class IdleSource final : public source::Source {
 public:
  source::Limits limits() const override {
    source::Limits limits;
    limits.name = "idle";
    limits.full_scale_pu = 1.5;
    limits.sample_rates_hz = {8000};
    limits.nominal_hz = {50};
    return limits;
  }

 protected:
  Result<source::Played> deviation(const source::Stimulus&) const override {
    return source::Played{};
  }
  Status power_up() override { return Done{}; }
  Status begin() override { return Done{}; }
  // As a driver that streams: it takes the samples and does nothing with them.
  Result<std::int64_t> play_until(std::int64_t until_tick) override {
    const auto voltage_pu = samples(tick(), until_tick - tick());
    return voltage_pu.ok() ? Result<std::int64_t>(until_tick) : Error{voltage_pu.error()};
  }
  Status switch_off() noexcept override { return Done{}; }
};

// Accepts its settings, then reports once a poll, as an outlet does every 16 ms.
class IdleLink final : public link::Link {
 public:
  explicit IdleLink(const profile::Plan& plan) : plan_(plan) {}

  std::string name() const override { return "idle"; }

  Status open() override { return Done{}; }
  Status send(const std::string&, const gs::wire::Downlink&) override { return Done{}; }

  Status poll(link::Happenings& happenings) override {
    if (!joined_) {
      joined_ = true;
      for (const profile::Outlet& outlet : plan_.outlets) {
        link::OutletPresence here{outlet.id, "idle", {}};
        here.hello.sample_rate_hz = static_cast<std::int32_t>(plan_.stimulus.sample_rate_hz);
        here.hello.nominal_hz = static_cast<std::int32_t>(plan_.grid.nominal_hz);
        happenings.joined.push_back(here);
      }
      return Done{};
    }
    for (const profile::Outlet& outlet : plan_.outlets) {
      gs::wire::Uplink message;
      message.kind =
          polls_ == 0 ? gs::wire::UplinkKind::kSettingsAnswer : gs::wire::UplinkKind::kMeasurement;
      if (polls_ == 0) {
        message.settings_answer = {};
      } else {
        message.measurement = {50.0F, 0.0F, 1.0F, gs::outlet::Validity::kValid};
      }
      message.sample = polls_ * 128;
      happenings.messages.push_back({outlet.id, message});
    }
    ++polls_;
    return Done{};
  }

  void close() noexcept override {}

 private:
  const profile::Plan& plan_;
  bool joined_ = false;
  std::uint64_t polls_ = 0;
};

class IdleRelaySense final : public relay::RelaySense {
 public:
  std::size_t channels() const override { return 0; }
  relay::Alignment alignment() const override { return {}; }
  Status poll(std::vector<relay::Edge>&) override { return Done{}; }
};

class IdleStation final : public station::Station {
 public:
  IdleStation(const profile::Plan& plan, double block_s)
      : plan_(plan), link_(plan), block_s_(block_s) {}

  std::string name() const override { return "idle"; }
  source::Source& source() override { return source_; }
  link::Link& link() override { return link_; }
  relay::RelaySense& relay_sense() override { return relay_sense_; }
  std::vector<station::Slot> slots() const override {
    std::vector<station::Slot> slots;
    for (const profile::Outlet& outlet : plan_.outlets) {
      slots.push_back({"idle", outlet.id, outlet.id, slots.size()});
    }
    return slots;
  }
  record::BenchUncertainty uncertainty() override { return {}; }
  bool outlets_count_ticks() const override { return true; }
  double block_s() const override { return block_s_; }

 private:
  const profile::Plan& plan_;
  IdleSource source_;
  IdleLink link_;
  IdleRelaySense relay_sense_;
  double block_s_;
};

}  // namespace

std::unique_ptr<station::Station> idle_station(const profile::Plan& plan, double block_s) {
  return std::make_unique<IdleStation>(plan, block_s);
}

}  // namespace gsbench::performance
