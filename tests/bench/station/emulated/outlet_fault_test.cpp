// Outlets and their cables that fail in a run, with the real parts. What is asked of each run is in
// desk_of_four.cpp.
#include "desk_of_four.hpp"
#include <test_support/temporary_folder.hpp>

#include <csignal>
#include <cstring>
#include <ostream>

#include <emulated/mains.hpp>
#include <process/child.hpp>

namespace gsbench::station::test {
namespace {

using gsbench::test::Bytes;
using gsbench::test::each_message;
using gsbench::test::every_nth_byte;
using record::Verdict;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

using OutletFault = FaultyDesk;

TEST_F(OutletFault, NoneLetsAllFourPassAndTheRecordSaysWhereTheyAre) {
  play();
  expect_all_whole();
  EXPECT_THAT(record_.outlets[kM4].link, StartsWith("/dev/pts/"));
  EXPECT_THAT(record_.outlets[kHost].link, StartsWith("/dev/pts/"));
  EXPECT_NE(record_.outlets[kM4].link, record_.outlets[kHost].link);
  EXPECT_EQ(record_.outlets[kRadioA].link, desk().broker()->url());
  EXPECT_EQ(record_.outlets[kRadioB].link, desk().broker()->url());
  EXPECT_EQ(record_.outlets[kM4].id, "m4");
  EXPECT_EQ(record_.outlets[kRadioB].id, "radio-b");
}

TEST_F(OutletFault, AnEmulatorThatIsKilledFallsSilent) {
  at(0.5, [&] { desk().outlet_process(kM4).kill(); });
  play();
  expect_fault(kM4, "fell silent after its sample ");
}

TEST_F(OutletFault, AnEmulatorThatIsKilledAndStartedAgainBeganAnew) {
  at(0.5, [&] { kill_and_restart(kM4); });
  play();
  expect_fault(kM4, "began anew after its sample ");
}

TEST_F(OutletFault, AProcessThatIsKilledAndStartedAgainBeganAnew) {
  at(0.5, [&] { kill_and_restart(kHost); });
  play();
  expect_fault(kHost, "began anew after its sample ");
}

TEST_F(OutletFault, AProcessBehindTheBrokerThatIsKilledAndStartedAgainIsTold) {
  at(0.5, [&] { kill_and_restart(kRadioB); });
  play();
  expect_faults({{kRadioB, ""}});
  EXPECT_THAT(record_.outlets[kRadioB].fault,
              AnyOf(HasSubstr("left the broker"), HasSubstr("began anew after its sample ")));
}

// What a second life says is by another count: none of it may stand at a wrong time in the record.
TEST_F(OutletFault, AnOutletThatBeganAnewLeavesOnlyItsFirstLifeInTheRecord) {
  at(0.6, [&] { kill_and_restart(kHost); });
  play();
  const std::vector<std::int64_t>& ticks = record_.outlets[kHost].trace.tick;
  ASSERT_FALSE(ticks.empty());
  EXPECT_TRUE(std::is_sorted(ticks.begin(), ticks.end()));
  EXPECT_LT(ticks.back(), plan_.duration_ticks());
}

TEST_F(OutletFault, AnOutletThatIsStoppedFallsSilent) {
  at(0.5, [&] { ASSERT_EQ(::kill(desk().outlet_process(kHost).pid(), SIGSTOP), 0); });
  play();
  expect_fault(kHost, "fell silent after its sample ");
}

struct Spoiling {
  const char* name;
  void (*spoil)(Bytes&);
};

void PrintTo(const Spoiling& spoiling, std::ostream* out) {
  *out << spoiling.name;
}

class SpoiledCable : public FaultyDesk, public testing::WithParamInterface<Spoiling> {};

TEST_P(SpoiledCable, IsToldOfItsOutletAlone) {
  at(0.5, [&] { desk().cable(kM4).spoil(every_nth_byte(97, GetParam().spoil)); });
  play();
  // The frame that was hit, or by then its number.
  expect_faults({{kM4, ""}});
  EXPECT_THAT(record_.outlets[kM4].fault,
              AnyOf(HasSubstr("sent a damaged frame"), HasSubstr("of its messages were lost")));
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpoiledCable,
                         testing::Values(Spoiling{"FlippedBits", gsbench::test::flip_a_bit},
                                         Spoiling{"DroppedBytes", gsbench::test::drop_a_byte},
                                         Spoiling{"DoubledBytes", gsbench::test::double_a_byte},
                                         Spoiling{"ReorderedBytes",
                                                  gsbench::test::reorder_two_bytes}),
                         [](const auto& kind) { return kind.param.name; });

TEST_F(OutletFault, OneOfAnotherProtocolVersionIsNotSpokenTo) {
  desk().cable(kHost).spoil(each_message([](const Bytes& message) -> std::vector<Bytes> {
    gs::wire::Uplink uplink;
    std::uint32_t sequence = 0;
    if (gs::wire::decode(message.data(), message.size(), uplink, sequence) !=
            gs::wire::Decoded::kOk ||
        uplink.kind != gs::wire::UplinkKind::kHello) {
      return {message};
    }
    uplink.hello.protocol_version = 77;
    Bytes other(gs::wire::kLongestMessage);
    other.resize(gs::wire::encode(uplink, sequence, other.data(), other.size()));
    return {other};
  }));
  play();
  expect_fault(kHost, "speaks protocol 77, not ");
  EXPECT_TRUE(record_.outlets[kHost].settings.empty()) << "it was sent settings";
  EXPECT_TRUE(record_.outlets[kHost].trace.tick.empty()) << "what it says may mean anything";
}

TEST_F(OutletFault, OneThatNeverSaysHelloStopsTheRunBeforeItBegins) {
  desk().cable(kHost).spoil([](Bytes& bytes) { bytes.clear(); });
  play();
  EXPECT_EQ(record_.verdict, Verdict::kError);
  EXPECT_EQ(record_.verdict_reason, desk().serial_ports()[kHost] + ": no outlet answers");
}

TEST_F(OutletFault, TwoOnSerialLinesWithOneIdStopTheRunBeforeItBegins) {
  desk().cable(kHost).spoil(each_message([](const Bytes& message) -> std::vector<Bytes> {
    gs::wire::Uplink uplink;
    std::uint32_t sequence = 0;
    if (gs::wire::decode(message.data(), message.size(), uplink, sequence) !=
            gs::wire::Decoded::kOk ||
        uplink.kind != gs::wire::UplinkKind::kHello) {
      return {message};
    }
    std::strcpy(uplink.hello.id, "m4");
    Bytes twin(gs::wire::kLongestMessage);
    twin.resize(gs::wire::encode(uplink, sequence, twin.data(), twin.size()));
    return {twin};
  }));
  play();
  EXPECT_EQ(record_.verdict, Verdict::kError);
  EXPECT_EQ(record_.verdict_reason, "two outlets say they are m4: on " + desk().serial_ports()[0] +
                                        " and on " + desk().serial_ports()[1]);
}

// Behind a broker a twin may come at any time: another piece of hardware with the same id.
TEST_F(OutletFault, ATwinThatComesInTheMiddleIsToldOfItsIdAlone) {
  const gsbench::test::TemporaryFolder folder;
  emulated::MainsOptions options;
  options.folder = folder.path().string();
  options.outlets = {{"spacer", 0.0},
                     {"spacer-2", 0.0},
                     {"spacer-3", 0.0},
                     {"spacer-4", 0.0},
                     {"radio-b", 0.0}};  // the fifth instance, which the desk does not have
  auto mains = emulated::Mains::create(options);
  ASSERT_TRUE(mains.ok()) << mains.error();
  std::unique_ptr<process::Child> twin;
  at(0.5, [&] {
    const broker::Login& login = desk().broker()->outlet("radio-b");
    auto started = process::Child::start(
        {{GS_OUTLET_PROGRAM, "--mqtt", desk().broker()->url(), "--ca", desk().broker()->ca_file(),
          "--user", login.user, "--password-file", folder.write("password", login.password + "\n"),
          "--terminals", mains.value()->terminal_path(4), "--doorbell",
          mains.value()->doorbell_path(4)},
         ""});
    ASSERT_TRUE(started.ok()) << started.error();
    twin = std::make_unique<process::Child>(started.take());
  });
  play();
  expect_fault(kRadioB, "is there twice: ");
}

}  // namespace
}  // namespace gsbench::station::test
