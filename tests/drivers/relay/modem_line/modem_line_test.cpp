// What is particular to modem lines: several contacts on a port, a busy machine, a lost port. The
// rest is in tests/contracts/relay.
#include "modem_lines.hpp"
#include <test_support/clocked_source.hpp>
#include <test_support/demand.hpp>
#include <test_support/waiting.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using relay::Alignment;
using relay::Edge;
using relay::ModemLine;
using relay::ModemLineSense;
using std::chrono::microseconds;
using testing::HasSubstr;

constexpr auto kMillisecond = std::chrono::milliseconds(1);

class OnModemLines : public testing::Test {
 protected:
  OnModemLines() {
    lines_.set("/dev/a", TIOCM_CTS | TIOCM_DSR);
    lines_.set("/dev/b", TIOCM_CAR);
  }
  ~OnModemLines() override { lines_.end(); }

  ModemLineSense& open() {
    demand(sense_.open());
    source_.clock = {lines_.now(), 1.0 / 8000.0, 0.0002};
    return sense_;
  }
  std::vector<Edge> polled() {
    std::vector<Edge> edges;
    demand(sense_.poll(edges));
    return edges;
  }
  double uncertainty_s() const { return sense_.alignment().uncertainty_ticks / 8000.0; }

  ModemLines lines_;
  ClockedSource source_;
  ModemLineSense sense_{
      {{{"/dev/a", ModemLine::kCts}, {"/dev/b", ModemLine::kDcd}, {"/dev/a", ModemLine::kDsr}}},
      source_,
      lines_.system()};
};

TEST_F(OnModemLines, FeedsTheContactsFromRtsAndDtr) {
  open();
  EXPECT_EQ(lines_.outputs("/dev/a"), TIOCM_RTS | TIOCM_DTR);
  EXPECT_EQ(lines_.outputs("/dev/b"), TIOCM_RTS | TIOCM_DTR);
}

TEST_F(OnModemLines, SeveralContactsOnOnePortAreSeparateChannels) {
  open();
  lines_.advance(10 * kMillisecond);
  EXPECT_THAT(polled(), testing::IsEmpty());
  lines_.set("/dev/a", TIOCM_CTS);
  lines_.advance(2 * kMillisecond);
  const std::vector<Edge> dsr = polled();
  ASSERT_EQ(dsr.size(), 1U);
  EXPECT_EQ(dsr[0].channel, 2U);
  EXPECT_FALSE(dsr[0].closed);
  lines_.set("/dev/b", 0);
  lines_.advance(2 * kMillisecond);
  const std::vector<Edge> dcd = polled();
  ASSERT_EQ(dcd.size(), 1U);
  EXPECT_EQ(dcd[0].channel, 1U);
}

TEST_F(OnModemLines, AnEdgeIsStampedBetweenItsTwoReadings) {
  const ModemLineSense& sense = open();
  // Readings every 1 ms; the line changes 0.4 ms after one of them.
  lines_.advance(20 * kMillisecond + microseconds(400));
  lines_.set("/dev/a", TIOCM_DSR);
  lines_.advance(5 * kMillisecond);
  const std::vector<Edge> edges = polled();
  ASSERT_EQ(edges.size(), 1U);
  const Alignment alignment = sense.alignment();
  const double edge_ms = (static_cast<double>(edges[0].count) - alignment.count_at_tick_0) /
                         alignment.counts_per_tick / 8.0;
  EXPECT_NEAR(edge_ms, 20.5, 1e-6);
  EXPECT_EQ(alignment.tick_of(edges[0].count), 164);
  // Half of 1 ms, 1 ms of the adapter, 0.2 ms of the source, half a tick.
  EXPECT_NEAR(uncertainty_s(), 0.0017 + 0.0000625, 1e-7);
}

// The uncertainty of the source's clock on this machine is in both.
TEST_F(OnModemLines, AnInstantOfThisMachineIsCountedLikeAnEdge) {
  const ModemLineSense& sense = open();
  source_.clock->uncertainty_s = 0.01;
  const Alignment alignment = sense.alignment();
  EXPECT_EQ(alignment.tick_of(sense.count_at(lines_.now() + kMillisecond).value()), 8);
  EXPECT_NEAR(alignment.uncertainty_ticks / 8.0, 11.5 + 0.0625, 1e-6);
  EXPECT_NEAR(alignment.uncertainty_between_ticks / 8.0, 1.5 + 0.125, 1e-6);
}

TEST_F(OnModemLines, StatesWhatIsKnownOfItsUncertaintyBeforeTheSourceStarts) {
  EXPECT_NEAR(uncertainty_s(), 0.0015 + 0.0000625, 1e-7);
  source_.known.host_clock_uncertainty_s = 0.01;
  EXPECT_NEAR(uncertainty_s(), 0.0115 + 0.0000625, 1e-7);
  EXPECT_THAT(sense_.not_known_yet(), HasSubstr("how late the source starts"));
}

TEST_F(OnModemLines, ABusyMachineIncreasesTheUncertaintyOfTheEdgesItDelays) {
  open();
  lines_.advance(5 * kMillisecond);
  lines_.stall(30 * kMillisecond);
  lines_.advance(5 * kMillisecond);
  EXPECT_NEAR(uncertainty_s(), 0.0017 + 0.0000625, 1e-7) << "there was no edge meanwhile";
  lines_.set("/dev/b", 0);
  lines_.stall(30 * kMillisecond);
  lines_.advance(5 * kMillisecond);
  EXPECT_EQ(polled().size(), 1U);
  // 30 to 31 ms between the readings.
  EXPECT_GT(uncertainty_s(), 0.0150 + 0.0012);
  EXPECT_LT(uncertainty_s(), 0.0155 + 0.0013);
  lines_.set("/dev/b", TIOCM_CAR);
  lines_.advance(5 * kMillisecond);
  EXPECT_EQ(polled().size(), 1U);
  EXPECT_GT(uncertainty_s(), 0.0150) << "the largest so far counts";
}

TEST_F(OnModemLines, AContactThatIsOpenAtFirstIsReportedAsOpening) {
  lines_.set("/dev/b", 0);
  open();
  lines_.advance(3 * kMillisecond);
  const std::vector<Edge> edges = polled();
  ASSERT_EQ(edges.size(), 1U);
  EXPECT_EQ(edges[0].channel, 1U);
  EXPECT_FALSE(edges[0].closed);
}

TEST_F(OnModemLines, ALostPortIsAnErrorOnceAndForAll) {
  open();
  lines_.set("/dev/b", 0);
  lines_.advance(3 * kMillisecond);
  lines_.fail("/dev/a", EIO);
  lines_.advance(3 * kMillisecond);
  std::vector<Edge> edges;
  // The reader has met the error; it stores it a moment later.
  ASSERT_TRUE(until([&] { return !sense_.poll(edges).ok(); }));
  for (int i = 0; i < 2; ++i) {
    const auto lost = sense_.poll(edges);
    ASSERT_FALSE(lost.ok());
    EXPECT_THAT(lost.error(), HasSubstr("/dev/a: reading its modem lines: Input/output error"));
  }
  EXPECT_EQ(edges.size(), 1U) << "what other ports saw is not lost";
}

TEST_F(OnModemLines, APortWithoutModemLinesIsRefused) {
  lines_.fail("/dev/b", ENOTTY);
  const auto opened = sense_.open();
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error(), HasSubstr("/dev/b: switching RTS and DTR on: Inappropriate ioctl"));
}

TEST(ModemLineSense, ReportsAPortThatCannotBeOpened) {
  const ClockedSource source;
  ModemLineSense sense({{{"/nowhere/ttyUSB0", ModemLine::kCts}}}, source);
  const auto opened = sense.open();
  ASSERT_FALSE(opened.ok());
  EXPECT_THAT(opened.error(),
              HasSubstr("/nowhere/ttyUSB0: opening it for its modem lines: No such"));
  ModemLineSense file({{{"/dev/null", ModemLine::kCts}}}, source);
  EXPECT_THAT(file.open().error(), HasSubstr("/dev/null: opening it"));
}

}  // namespace
}  // namespace gsbench::test
