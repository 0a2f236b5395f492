// Downlink messages for tests, and a filter of uplink messages by kind.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include <wire/codec.hpp>

namespace gs::wire::test {

inline Downlink downlink(DownlinkKind kind) {
  Downlink message;
  message.kind = kind;
  return message;
}

inline Downlink ping(std::uint32_t token) {
  Downlink message = downlink(DownlinkKind::kPing);
  message.token = token;
  return message;
}

inline Downlink command(bool close, std::uint32_t request = 0) {
  Downlink message = downlink(DownlinkKind::kCommand);
  message.close_relay = close;
  message.request = request;
  return message;
}

inline Downlink settings_message(const outlet::Settings& settings) {
  Downlink message = downlink(DownlinkKind::kSettings);
  message.settings = settings;
  return message;
}

inline std::vector<Uplink> of_kind(const std::vector<Uplink>& messages, UplinkKind kind) {
  std::vector<Uplink> some;
  std::copy_if(messages.begin(), messages.end(), std::back_inserter(some),
               [kind](const Uplink& message) { return message.kind == kind; });
  return some;
}

}  // namespace gs::wire::test
