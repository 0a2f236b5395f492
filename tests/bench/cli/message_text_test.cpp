// The messages of outlets as text and as JSON.
#include <message_text.hpp>
#include <wire_test/messages.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <link/unreadable.hpp>

namespace gsbench::cli {
namespace {

using gs::wire::Uplink;
using gs::wire::UplinkKind;
using testing::HasSubstr;

using Names = std::vector<std::string>;

// Where the keys are not the name of the field in wire/README.md. The id and the start number are
// printed for every kind, apart from these fields.
const std::map<std::string, Names> kOtherKeys = {
    {"protocol_version", {"protocol"}},
    {"id", {}},
    {"start_number", {}},
    {"firmware_version", {"firmware"}},
    {"capabilities", {"keeps_settings", "has_watchdog"}},
    {"error", {"answer"}},
    {"version", {"settings_version"}},
    {"digest", {"settings_digest"}},
    {"trust", {"estimate"}},
    {"closed", {"relay"}},
    {"relay_closed", {"relay"}},
    {"code", {"error"}}};

Uplink message_of(UplinkKind kind) {
  std::mt19937 random(1);
  Uplink message = gs::wire::test::uplink(kind, gs::wire::test::Fill::kHighest, random);
  if (kind == UplinkKind::kHello) {
    message.hello.protocol_version = gs::wire::kProtocolVersion;
  }
  return message;
}

Names keys_of_fields(const Uplink& message) {
  Names keys;
  const auto object = fields_of(message);
  for (const auto& [key, value] : object.items()) {
    keys.push_back(key);
  }
  return keys;
}

TEST(MessageText, TheKeysOfAMessageAreAllItsFields) {
  for (const UplinkKind kind : gs::wire::test::uplink_kinds()) {
    Names expected;
    for (const std::string& name : link::field_names(kind)) {
      const auto other = kOtherKeys.find(name);
      const Names keys = other == kOtherKeys.end() ? Names{name} : other->second;
      expected.insert(expected.end(), keys.begin(), keys.end());
    }
    EXPECT_THAT(keys_of_fields(message_of(kind)), testing::UnorderedElementsAreArray(expected))
        << to_string(kind);
  }
}

TEST(MessageText, OfAHelloOfAnotherVersionOnlyTheVersionIsRead) {
  Uplink message = message_of(UplinkKind::kHello);
  message.hello.protocol_version += 1;
  EXPECT_EQ(keys_of_fields(message), Names{"protocol"});
}

TEST(MessageText, AStatusSaysWhyTheRelayIsOpenAndInWhatPhaseTheOutletIs) {
  Uplink message = message_of(UplinkKind::kStatus);
  message.status = {};
  message.status.relay_closed = false;
  message.status.cause = gs::outlet::Cause::kCommand;
  message.status.phase = gs::outlet::Phase::kCooling;
  EXPECT_THAT(details(message),
              HasSubstr("relay open, cause " + std::string(to_string(gs::outlet::Cause::kCommand)) +
                        ", cooling, "));
}

TEST(MessageText, ACommandAnswerNamesTheSessionOfItsCentre) {
  Uplink message = message_of(UplinkKind::kCommandAnswer);
  message.command_answer = {3, false, 4000000000};
  EXPECT_EQ(details(message), "request 3 of session 4000000000: relay open");
  EXPECT_EQ(fields_of(message)["session"], 4000000000);
}

}  // namespace
}  // namespace gsbench::cli
