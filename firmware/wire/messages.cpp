#include <wire/messages.hpp>

namespace gs::wire {

Downlink identify() {
  Downlink message;
  message.kind = DownlinkKind::kIdentify;
  return message;
}

const char* to_string(UplinkKind kind) {
  switch (kind) {
    case UplinkKind::kHello:
      return "hello";
    case UplinkKind::kSettingsAnswer:
      return "settings answer";
    case UplinkKind::kMeasurement:
      return "measurement";
    case UplinkKind::kEvent:
      return "event";
    case UplinkKind::kLse:
      return "lse";
    case UplinkKind::kEstimate:
      return "estimate";
    case UplinkKind::kDecision:
      return "decision";
    case UplinkKind::kRelay:
      return "relay";
    case UplinkKind::kAborted:
      return "aborted";
    case UplinkKind::kCommandAnswer:
      return "command answer";
    case UplinkKind::kStatus:
      return "status";
    case UplinkKind::kSelfTest:
      return "self test";
    case UplinkKind::kEcho:
      return "echo";
    case UplinkKind::kError:
      return "error";
  }
  return "unknown";
}

const char* to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::kBadFrame:
      return "bad frame received";
    case ErrorCode::kMalformed:
      return "malformed message received";
    case ErrorCode::kUnknownKind:
      return "message of an unknown kind received";
    case ErrorCode::kSamplesLost:
      return "samples lost";
    case ErrorCode::kSettingsStorage:
      return "settings could not be kept";
    case ErrorCode::kWatchdog:
      return "restarted by the watchdog";
    case ErrorCode::kClock:
      return "the crystal did not start";
  }
  return "unknown error";
}

}  // namespace gs::wire
