// Downlink messages for tests, and a filter of uplink messages by kind.
#pragma once

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <vector>

#include <wire/codec.hpp>

namespace gs::wire::test {

constexpr std::uint32_t kSession = 77;  // of all messages here
constexpr std::uint32_t kStart = 0;     // of outlets whose identity does not say otherwise

inline Downlink downlink(DownlinkKind kind) {
  Downlink message;
  message.kind = kind;
  message.session = kSession;
  return message;
}

inline Downlink ping(std::uint32_t token) {
  Downlink message = downlink(DownlinkKind::kPing);
  message.token = token;
  return message;
}

// Each command has a new request by default.
inline std::uint32_t next_request() {
  static std::uint32_t newest = 0;
  return ++newest;
}

inline Downlink command(bool close, std::uint32_t request = next_request()) {
  Downlink message = downlink(DownlinkKind::kCommand);
  message.close_relay = close;
  message.request = request;
  message.start_number = kStart;
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
