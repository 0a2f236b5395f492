// A shipped profile as samples of an outlet's ADC, and what the firmware on this machine makes of
// them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <outlet/outlet.hpp>
#include <wire/messages.hpp>

namespace gs::test {

constexpr double kSampleRate_hz = 8000.0;

struct Played {
  outlet::Hardware hardware;
  outlet::Settings settings;
  std::vector<std::int16_t> samples;
  std::uint32_t loss = 0;  // sample of the first loss
};

// What the first outlet of a profile gets. It decides by the grid's state, whatever the profile
// says.
Played played(const std::string& profile);

// The frames that the application sends.
std::vector<std::uint8_t> frames_here(const Played& played);
std::vector<wire::Uplink> messages_in(const std::vector<std::uint8_t>& frames);

}  // namespace gs::test
