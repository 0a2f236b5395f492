#include <outlet/name_table.hpp>
#include <wire/messages.hpp>

namespace gs::wire {
namespace {

bool is_id(const char* id) {
  const char* at = id;
  for (; *at != '\0'; ++at) {
    const bool allowed = (*at >= 'a' && *at <= 'z') || (*at >= 'A' && *at <= 'Z') ||
                         (*at >= '0' && *at <= '9') || *at == '-' || *at == '_' || *at == '.';
    if (!allowed) {
      return false;
    }
  }
  return at != id;
}

// False for NaN.
bool is_delay(float delay_s) {
  return delay_s >= 0.0f && delay_s <= kLongestDelay_s;
}

}  // namespace

bool is_valid(const Hello& hello) {
  if (!is_id(hello.id) || hello.protocol_version != kProtocolVersion) {
    return is_id(hello.id);
  }
  return hello.sample_rate_hz >= kLeastSampleRate_hz &&
         hello.sample_rate_hz <= kMostSampleRate_hz &&
         (hello.nominal_hz == 50 || hello.nominal_hz == 60) && is_delay(hello.tracker_delay_s) &&
         is_delay(hello.voltage_delay_s);
}

Downlink identify() {
  Downlink message;
  message.kind = DownlinkKind::kIdentify;
  return message;
}

const char* to_string(UplinkKind kind) {
  static constexpr const char* kNames[] = {
      "unknown",  "hello", "settings answer", "measurement",    "event",  "lse",       "estimate",
      "decision", "relay", "aborted",         "command answer", "status", "self test", "echo",
      "error"};
  return outlet::name_of<kLastUplink>(kind, kNames);
}

const char* to_string(ErrorCode code) {
  static constexpr const char* kNames[] = {"unknown error",
                                           "bad frame received",
                                           "malformed message received",
                                           "message of an unknown kind received",
                                           "samples lost",
                                           "settings could not be stored",
                                           "restarted by the watchdog",
                                           "the crystal did not start",
                                           "message of an unknown session received",
                                           "command for another start received"};
  return outlet::name_of<kLastErrorCode>(code, kNames, kNames[0]);
}

}  // namespace gs::wire
