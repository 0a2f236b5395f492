// Which outlet is in which slot, and what its record is called.
#include "fake_station.hpp"
#include "plans.hpp"
#include <test_support/temporary_folder.hpp>

#include <gmock/gmock.h>

#include <record/store.hpp>
#include <station/run.hpp>

namespace gsbench::station::test {
namespace {

using testing::HasSubstr;

TEST(Claim, OutletWithAnotherSerialNumberThanItsSlotIsExcluded) {
  FakeStation station(with(&Script::requires_serial_number, "GS-7"));
  const record::RunRecord record = run(plan(0.5), station, {});
  EXPECT_EQ(record.verdict, record::Verdict::kError);
  EXPECT_THAT(record.verdict_reason, HasSubstr("GS-7 is not at its place"));
  ASSERT_EQ(record.outlets.size(), 2U);
  EXPECT_EQ(record.outlets[0].verdict, record::Verdict::kPass) << record.outlets[0].fault;
  EXPECT_EQ(record.outlets[1].id, "GS-7");
  EXPECT_EQ(record.outlets[1].fault,
            "is not at its place: the station names serial_number \"GS-7\" for fake, the outlet "
            "there reports \"serial-2\"");
  EXPECT_TRUE(record.outlets[1].reports.trace.tick.empty());
  EXPECT_TRUE(station.sent_to(1).empty()) << "it gets no settings that are for another one";
}

TEST(Claim, OutletWithTheSerialNumberOfItsSlotTakesPart) {
  FakeStation station(with(&Script::requires_serial_number, "serial-2"));
  EXPECT_EQ(run(plan(0.5), station, {}).verdict, record::Verdict::kPass);
}

// The last slot has the name of what the first outlet reports, and another outlet or none.
TEST(Claim, RecordsHaveDifferentIdsIfAnOutletReportsTheNameOfAnotherSlot) {
  Script another = with(&Script::requires_serial_number, "serial-1");
  Script none = another;
  none.joins = false;
  Script contact = another;
  contact.without_link = true;
  for (const Script& script : {another, none, contact}) {
    const gsbench::test::TemporaryFolder folder;
    record::Writer writer(folder.file("run.gsbench"));
    RunOptions options;
    options.writer = &writer;
    FakeStation station(script);
    const record::RunRecord record =
        run(parse("title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n"
                  "[signal]\nduration_s = 0.5\n[[outlet]]\ncount = 2\n"
                  "[[expect]]\nmeasure = \"relay.end\"\nequals = \"closed\"\n"),
            station, options);
    ASSERT_EQ(record.outlets.size(), 2U);
    EXPECT_EQ(record.outlets[0].id, "serial-1");
    EXPECT_EQ(record.outlets[0].verdict, record::Verdict::kPass) << record.outlets[0].fault;
    EXPECT_EQ(record.outlets[1].id, "serial-1 at fake");
  }
}

}  // namespace
}  // namespace gsbench::station::test
