#include "idle_station.hpp"

#include <outlet/settings.hpp>

namespace gsbench::performance {
namespace {

using drivers::Done;
using drivers::Result;
using drivers::Status;

class IdleSource final : public source::Source {
 public:
  source::SourceInfo info() const override { return {"idle", 1.5, true}; }
  Status start(const source::SourceSettings&) override { return Done{}; }
  Status play(std::int64_t, const float*, std::size_t) override { return Done{}; }
  void make_safe() noexcept override {}
};

// Accepts its settings, then reports once a poll, as an outlet does every 16 ms.
class IdleLink final : public link::Link {
 public:
  explicit IdleLink(const profile::Plan& plan) : plan_(plan) {}

  std::string name() const override { return "idle"; }

  Result<std::vector<link::OutletPresence>> open() override {
    std::vector<link::OutletPresence> present;
    for (const profile::Outlet& outlet : plan_.outlets) {
      link::OutletPresence here{outlet.id, "idle", {}};
      here.hello.sample_rate_hz = static_cast<std::int32_t>(plan_.stimulus.sample_rate_hz);
      here.hello.nominal_hz = static_cast<std::int32_t>(plan_.grid.nominal_hz);
      present.push_back(here);
    }
    return present;
  }

  Status send(std::size_t, const gs::wire::Downlink&) override { return Done{}; }

  Status poll(std::vector<link::Received>& messages, std::vector<link::Fault>&) override {
    for (std::size_t i = 0; i < plan_.outlets.size(); ++i) {
      gs::wire::Uplink message;
      message.kind =
          polls_ == 0 ? gs::wire::UplinkKind::kSettingsAnswer : gs::wire::UplinkKind::kMeasurement;
      if (polls_ == 0) {
        message.settings_answer = {};
      } else {
        message.measurement = {50.0F, 0.0F, 1.0F, gs::outlet::Validity::kValid};
      }
      message.sample = polls_ * 128;
      messages.push_back({i, message});
    }
    ++polls_;
    return Done{};
  }

  void close() noexcept override {}

 private:
  const profile::Plan& plan_;
  std::uint64_t polls_ = 0;
};

class IdleRelaySense final : public relay::RelaySense {
 public:
  double uncertainty_ticks() const override { return 0.0; }
  Status poll(std::vector<relay::Edge>&) override { return Done{}; }
};

class IdleStation final : public station::Station {
 public:
  IdleStation(const profile::Plan& plan, double block_s) : link_(plan), block_s_(block_s) {}

  std::string name() const override { return "idle"; }
  source::Source& source() override { return source_; }
  link::Link& link() override { return link_; }
  relay::RelaySense& relay_sense() override { return relay_sense_; }
  record::BenchUncertainty uncertainty() override { return {}; }
  bool outlets_count_ticks() const override { return true; }
  double block_s() const override { return block_s_; }

 private:
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
