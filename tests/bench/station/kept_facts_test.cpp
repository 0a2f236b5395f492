// What a record keeps for a later judgement: who each outlet was, and everything that it was sent.
#include "plans.hpp"

#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <station/run.hpp>
#include <wire/codec.hpp>

namespace gsbench::station::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Reads settings as a record has them.
struct FromRecord {
  const std::map<std::string, double>& values;

  template <class T>
  void operator()(const gs::outlet::Field& field, T& value) const {
    value = static_cast<T>(values.at(field.name));
  }
  void rows(const gs::outlet::Field&, gs::outlet::ConditionRow* rows, std::uint8_t& count) const {
    count = static_cast<std::uint8_t>(values.at("condition_rows"));
    for (int row = 0; row < count; ++row) {
      const std::string name = fmt::format("condition_{:02}_", row + 1);
      rows[row].from_hz = static_cast<float>(values.at(name + "from_hz"));
      rows[row].rocof_below_hz_s = static_cast<float>(values.at(name + "rocof_below_hz_s"));
    }
  }
};

TEST(KeptFacts, AreAllSettingsThatTheOutletAcknowledged) {
  const profile::Plan plan =
      test::plan(0.5, "", "[[outlet]]\naccumulated_mw = 120.0\ndelay_s = 0.25\n");
  const record::OutletRecord outlet = run(plan, *simulated_station(plan, {}), {}).outlets.at(0);
  gs::outlet::Settings settings;
  FromRecord read{outlet.settings};
  gs::outlet::visit_fields(settings, read);
  EXPECT_EQ(settings.delay_s, 0.25F);
  EXPECT_EQ(fmt::format("{:08x}", gs::outlet::digest(settings)), outlet.settings_digest);
}

TEST(KeptFacts, AreTheMessagesThatWereSent) {
  const profile::Plan plan =
      test::plan(1.0, "", "[[outlet]]\n[[command]]\nat_s = 0.5\nswitch = \"off\"\n");
  const record::OutletRecord outlet = run(plan, *simulated_station(plan, {}), {}).outlets.at(0);
  std::vector<std::string> kinds;
  for (const record::Sent& sent : outlet.reports.sent) {
    gs::wire::Downlink message;
    std::uint32_t sequence = 0;
    ASSERT_EQ(gs::wire::decode(sent.message.data(), sent.message.size(), message, sequence),
              gs::wire::Decoded::kOk);
    kinds.push_back(sent.kind + " " + std::to_string(sent.tick));
    if (message.kind == gs::wire::DownlinkKind::kSettings) {
      EXPECT_EQ(fmt::format("{:08x}", gs::outlet::digest(message.settings)),
                outlet.settings_digest);
    }
  }
  EXPECT_THAT(kinds, ElementsAre("settings -1", "ask self test -1", "command 4000"));
}

TEST(KeptFacts, SayWhoEachOutletWas) {
  const profile::Plan plan = test::plan(0.5);
  const record::RunRecord record = run(plan, *simulated_station(plan, {}), {});
  const record::OutletRecord& first = record.outlets.at(0);
  EXPECT_EQ(first.board, "simulated");
  EXPECT_NE(first.instance, record.outlets.at(1).instance);
  EXPECT_EQ(first.protocol_version, gs::wire::kProtocolVersion);
  EXPECT_EQ(first.build, record.firmware_sha256.substr(0, 8));
  EXPECT_THAT(record.software, AllOf(HasSubstr("Eigen3 3."), HasSubstr("Linux ")));
  EXPECT_THAT(record.grid_text, HasSubstr("title"));
}

}  // namespace
}  // namespace gsbench::station::test
