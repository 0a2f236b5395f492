#include "played.hpp"

#include <control_centre/outlet_settings.hpp>
#include <wire_test/messages.hpp>

#include <cmath>

#include <gtest/gtest.h>

#include <app/endpoint.hpp>
#include <models/adc.hpp>
#include <models/noise.hpp>
#include <profile/load.hpp>

namespace gs::test {

using wire::test::Bytes;

Played played(const std::string& profile) {
  const gsbench::profile::Plan plan =
      gsbench::profile::load_profile(GSBENCH_SOURCE_DIR "/profiles/" + profile + ".toml");
  Played played;
  played.hardware.counts_per_pu = gsbench::models::kCounts_per_pu;
  played.settings =
      gsbench::control_centre::outlet_settings(plan.grid, plan.outlets.front().settings, 1);
  played.settings.method = outlet::kByGridState;
  std::vector<float> voltage_pu(static_cast<std::size_t>(plan.duration_ticks()));
  plan.synthesizer().render(0, voltage_pu.size(), voltage_pu.data());
  gsbench::models::add_gaussian({plan.seed, gsbench::models::kSourceNoise, 0}, 0, voltage_pu.size(),
                                plan.stimulus.noise_rms_pu(), voltage_pu.data());
  for (const float pu : voltage_pu) {
    played.samples.push_back(gsbench::models::adc_counts(pu, gsbench::models::kCounts_per_pu));
  }
  played.loss =
      static_cast<std::uint32_t>(std::lround(plan.stimulus.losses.front().at_s * kSampleRate_hz));
  return played;
}

Bytes frames_here(const Played& played) {
  class Collector final : public app::Carrier {
   public:
    bool send(const std::uint8_t* bytes, std::size_t count) override {
      frames.insert(frames.end(), bytes, bytes + count);
      return true;
    }
    Bytes frames;
  };
  Collector collector;
  app::Application app;
  app::SerialEndpoint endpoint(app, collector);
  app::Identity identity;
  app::set_text(identity.id, "counted");  // as in counting.cpp
  EXPECT_TRUE(app.start(played.hardware, identity, nullptr, endpoint, &played.settings));
  app.feed(played.samples.data(), played.samples.size(), endpoint);
  return collector.frames;
}

std::vector<wire::Uplink> messages_in(const Bytes& frames) {
  wire::FrameReader reader;
  std::vector<wire::Uplink> messages;
  for (const Bytes& bytes : wire::test::frames_in(reader, frames)) {
    std::uint32_t sequence = 0;
    EXPECT_EQ(wire::decode(bytes.data(), bytes.size(), messages.emplace_back(), sequence),
              wire::Decoded::kOk);
  }
  return messages;
}

}  // namespace gs::test
