// Devices without a link are tested by their contact alone.
#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/refusal.hpp>

#include <gmock/gmock.h>

#include <measures/catalogue.hpp>
#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

using record::Verdict;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kEnd = "measure = \"relay.end\"\nequals = \"open\"\n";

// One outlet at a loss of 500 MW at 0.5 s, with this limit and more.
profile::Plan plan_with(const std::string& limit, const std::string& more = "") {
  return parse(
      "title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[[grid.loss]]\n"
      "at_s = 0.5\npower_mw = 500.0\n[signal]\nduration_s = 1.0\n[[outlet]]\nid = \"r\"\n"
      "[[expect]]\n" +
      limit + more);
}

Script contact_only() {
  Script script;
  script.outlets = 1;
  script.relay_channels = 1;
  script.without_link = true;
  return script;
}

std::string refusal_of(const profile::Plan& plan, Script script = contact_only()) {
  FakeStation station(std::move(script));
  std::string refusal =
      gsbench::test::refusal_of<profile::ConfigurationError>([&] { (void)run(plan, station, {}); });
  EXPECT_FALSE(station.was_touched());
  return refusal;
}

TEST(ContactOnly, IsJudgedByItsContact) {
  Script script = contact_only();
  script.edges = {{0, 5600, false}};  // 0.2 s after the loss
  FakeStation station(script);
  const record::RunRecord record =
      run(plan_with(kEnd,
                    "[[expect]]\nmeasure = \"relay.delay\"\nunit = \"ms\"\nmin = 100\n"
                    "max = 300\n[[expect]]\nmeasure = \"relay.edges\"\nmin = 1\nmax = 1\n"),
          station, {});
  EXPECT_EQ(record.verdict, Verdict::kPass) << record.verdict_reason;
  ASSERT_EQ(record.outlets.size(), 1U);
  EXPECT_DOUBLE_EQ(record::find_measurement(record.outlets[0], "relay.delay")->value, 200.0);
}

TEST(ContactOnly, FailsIfTheContactDoesNotMove) {
  FakeStation station(contact_only());
  EXPECT_EQ(run(plan_with(kEnd), station, {}).verdict, Verdict::kFail);
}

TEST(ContactOnly, HasNoMeasureThatNeedsALink) {
  FakeStation station(contact_only());
  const record::RunRecord record = run(plan_with(kEnd), station, {});
  std::vector<std::string> names;
  for (const record::MeasurementResult& result : record.outlets.at(0).measurements) {
    names.push_back(result.name);
  }
  EXPECT_THAT(names, ElementsAre("relay.end", "relay.delay", "relay.edges", "relay.chatter",
                                 "trip.time", "relay.operate_hz"));
}

TEST(ContactOnly, IsOfferedTheseMeasuresOnly) {
  EXPECT_THAT(measures::measured_by_contact(),
              ElementsAre("relay.delay", "relay.end", "relay.edges", "relay.chatter", "trip.time",
                          "relay.operate_hz"));
}

TEST(ContactOnly, LimitThatNeedsALinkIsRefused) {
  EXPECT_THAT(refusal_of(plan_with("measure = \"event.count\"\nmax = 0\n")),
              AllOf(StartsWith("test.toml:13: event.count needs a link"), HasSubstr("outlet r"),
                    HasSubstr("slot fake"), HasSubstr("relay.delay, relay.end")));
}

TEST(ContactOnly, CommandIsRefused) {
  EXPECT_THAT(refusal_of(plan_with(kEnd, "[[command]]\nat_s = 0.5\nswitch = \"off\"\n")),
              HasSubstr("the command at 0.5 s cannot be sent: outlet r"));
}

TEST(ContactOnly, SettingsDuringTheRunAreRefused) {
  EXPECT_THAT(refusal_of(plan_with(kEnd, "[[settings]]\nat_s = 0.5\n")),
              HasSubstr("the settings of 0.5 s cannot be sent: outlet r"));
}

TEST(ContactOnly, NeedsARelayChannel) {
  Script script = contact_only();
  script.relay_channels = 0;
  EXPECT_THAT(refusal_of(plan_with(kEnd), script), HasSubstr("neither a link nor a relay channel"));
}

TEST(ContactOnly, NeedsALimit) {
  profile::Plan plan = plan_with(kEnd);
  plan.expectations[0].groups = {"others"};
  EXPECT_THAT(refusal_of(plan), HasSubstr("no limit applies to outlet r"));
}

TEST(ContactOnly, ContactThatIsOpenAtTheStartIsAnOpeningThen) {
  Script script = contact_only();
  script.edges = {{0, -800, true}, {0, -400, false}};
  FakeStation station(script);
  const record::RunRecord record = run(plan_with(kEnd), station, {});
  const record::OutletRecord& outlet = record.outlets.at(0);
  EXPECT_EQ(record::find_measurement(outlet, "relay.end")->text, "open");
  EXPECT_DOUBLE_EQ(record::find_measurement(outlet, "trip.time")->value, 0.0);
  ASSERT_EQ(outlet.reports.marks.size(), 1U);
}

TEST(ContactOnly, EdgesBeforeTheStartDoNotCount) {
  Script script = contact_only();
  script.edges = {{0, -800, false}, {0, -400, true}, {0, 5600, false}};
  FakeStation station(script);
  const record::RunRecord record = run(plan_with(kEnd), station, {});
  EXPECT_DOUBLE_EQ(record::find_measurement(record.outlets.at(0), "relay.edges")->value, 1.0);
}

TEST(ContactOnly, RunHasNoMarkers) {
  Script script = contact_only();
  script.counts_ticks = false;
  FakeStation station(script);
  EXPECT_EQ(run(plan_with(kEnd), station, {}).verdict, Verdict::kFail);
  EXPECT_EQ(station.tick(), 8000) << "no outlet has a clock that the dips would align";
}

}  // namespace
}  // namespace gsbench::station::test
