#include <outlet/name_table.hpp>
#include <wire/messages.hpp>

namespace gs::wire {

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
                                           "settings could not be kept",
                                           "restarted by the watchdog",
                                           "the crystal did not start"};
  return outlet::name_of<kLastErrorCode>(code, kNames, kNames[0]);
}

}  // namespace gs::wire
