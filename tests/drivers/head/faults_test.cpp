// Faults of the head, of the line and of the bench: the run ends with an error that names them, and
// make_safe() reports what is known of the output.
#include <head_driver_test/head_rig.hpp>

#include <gmock/gmock.h>

#include <head/codec.hpp>
#include <wire/frame.hpp>

namespace gsbench::test {
namespace {

using namespace std::chrono_literals;
using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;
using gs::head::Fault;
using gs::head::State;

// Changes the messages of one kind from the head.
template <class Message>
emulation::HeadEmulator::Spoiler changing(std::function<void(Message&)> change) {
  return [change](Bytes& frame) {
    gs::wire::FrameReader reader;
    for (const std::uint8_t byte : frame) {
      Message message;
      gs::head::Header header;
      if (reader.take(byte) == gs::wire::FrameReader::Taken::kMessage &&
          gs::head::decode_header(reader.message(), reader.size(), header) &&
          gs::head::decode(reader.message(), reader.size(), message)) {
        change(message);
        Bytes bytes(gs::head::kLongestMessage);
        bytes.resize(gs::head::encode(message, header.number, bytes.data(), bytes.size()));
        Bytes framed(gs::wire::kLongestFrame);
        framed.resize(gs::wire::frame(bytes.data(), bytes.size(), framed.data(), framed.size()));
        frame = framed;
        return;
      }
    }
  };
}

std::string error_of(const drivers::Status& status) {
  return status.ok() ? "" : status.error();
}

class HeadFault : public testing::Test {
 protected:
  ~HeadFault() override {
    rig_.head->spoil_from_bench({});
    rig_.head->spoil_to_bench({});
  }

  source::Source& source() { return rig_.source(); }
  emulation::HeadEmulator& head() { return *rig_.head; }

  void play_some() {
    rig_.start(mains_);
    advance(source(), 4000);
  }
  // The error of the next calls of advance().
  std::string error_of_advance() {
    const auto end = std::chrono::steady_clock::now() + 20s;
    for (std::int64_t tick = 8000; std::chrono::steady_clock::now() < end; tick += 800) {
      const auto played = source().advance(tick);
      if (!played.ok()) {
        return played.error();
      }
      tick = played.value();
    }
    return "";
  }
  std::string error_of_prepare() {
    const auto prepared = source().prepare(mains_);
    return prepared.ok() ? "" : prepared.error();
  }
  void expect_off() {
    EXPECT_TRUE(until([&] {
      const auto seen = head().observe();
      return seen.state != State::kPlaying && seen.code > seen.last_driven + 200;
    }));
  }

  HeadRig rig_;
  Mains mains_;
};

TEST_F(HeadFault, UnderrunIsNamed) {
  HeadRig rig(HeadPace::kRealTime);
  rig.start(mains_);
  std::this_thread::sleep_for(600ms);
  EXPECT_THAT(rig.source().advance(8000).error(), HasSubstr("was not there in time (underrun)"));
  EXPECT_EQ(error_of(rig.source().make_safe()), "");
  EXPECT_EQ(rig.head->observe().state, State::kOff);
}

TEST_F(HeadFault, UnderrunBeforeTheStartIsNamedByHold) {
  HeadRig rig(HeadPace::kRealTime);
  ASSERT_TRUE(rig.source().prepare(mains_).ok());
  ASSERT_TRUE(rig.source().energise().ok());
  std::this_thread::sleep_for(600ms);
  EXPECT_THAT(error_of(rig.source().hold()), HasSubstr("(underrun)"));
}

TEST_F(HeadFault, TripOfTheWatchdogIsNamed) {
  play_some();
  head().spoil_to_bench(changing<gs::head::Status>([](gs::head::Status& status) {
    status.state = State::kFaulted;
    status.fault = Fault::kWatchdog;
  }));
  EXPECT_THAT(error_of_advance(), HasSubstr("heard nothing from the bench for 200 ms (watchdog)"));
}

TEST_F(HeadFault, StarvedDacIsNamed) {
  play_some();
  head().spoil_to_bench(changing<gs::head::Status>([](gs::head::Status& status) {
    status.state = State::kFaulted;
    status.fault = Fault::kHardware;
  }));
  EXPECT_THAT(error_of_advance(), HasSubstr("DAC did not get its codes in time"));
}

TEST_F(HeadFault, RestartDuringTheRunIsNamed) {
  play_some();
  head().restart();
  EXPECT_THAT(error_of_advance(), HasSubstr("the head has restarted"));
  EXPECT_EQ(error_of(source().make_safe()), "");
  expect_off();
}

TEST_F(HeadFault, RestartIsNamedAlsoIfItsHelloIsLost) {
  play_some();
  head().spoil_to_bench(
      [lost = false](Bytes& frame) mutable { frame.resize(lost ? frame.size() : 0), lost = true; });
  head().restart();
  EXPECT_THAT(error_of_advance(), HasSubstr("restarted"));
}

TEST_F(HeadFault, AnotherProgramThatSwitchesOffEndsTheRun) {
  play_some();
  EXPECT_TRUE(head::Head::create(rig_.options).take()->source().make_safe().ok());
  // Its connection has replaced ours, on TCP.
  EXPECT_THAT(error_of_advance(), HasSubstr(head().port()));
  expect_off();
}

TEST_F(HeadFault, OutputThatIsOffIsNamed) {
  play_some();
  head().spoil_to_bench(
      changing<gs::head::Status>([](gs::head::Status& status) { status.state = State::kOff; }));
  EXPECT_THAT(error_of_advance(), HasSubstr("another program has switched the head's output off"));
}

TEST_F(HeadFault, SilenceIsNamed) {
  play_some();
  head().be_silent(true);
  EXPECT_THAT(error_of_advance(), HasSubstr("the head has not answered for 0.5 s"));
  EXPECT_THAT(error_of(source().make_safe()), HasSubstr("output state unknown"));
  head().be_silent(false);
  EXPECT_EQ(error_of(source().make_safe()), "");
  expect_off();
}

TEST_F(HeadFault, UnpluggedLineEndsTheRunAndTheOutputStateIsUnknown) {
  play_some();
  head().unplug();
  EXPECT_THAT(error_of_advance(), HasSubstr(head().port()));
  EXPECT_THAT(error_of(source().make_safe()),
              testing::AllOf(HasSubstr("output state unknown: " + head().port()),
                             HasSubstr("switches its output off by itself within 250 ms of the "
                                       "last message")));
  ASSERT_TRUE(head().plug_in().ok());
  EXPECT_EQ(error_of(source().make_safe()), "");
  expect_off();
  rig_.start(mains_);
}

TEST_F(HeadFault, LineThatIsPluggedInAgainIsUsedToSwitchOff) {
  play_some();
  head().unplug();
  ASSERT_TRUE(head().plug_in().ok());
  EXPECT_EQ(error_of(source().make_safe()), "");
  EXPECT_EQ(head().observe().state, State::kOff);
}

TEST_F(HeadFault, HeadOfAKilledBenchIsSwitchedOffByASourceThatWasNeverPrepared) {
  play_some();
  const auto other = head::Head::create(rig_.options).take();
  EXPECT_EQ(error_of(other->source().make_safe()), "");
  EXPECT_EQ(head().observe().state, State::kOff);
  EXPECT_EQ(error_of(other->source().make_safe()), "");
}

TEST_F(HeadFault, UnusableHeadsAreRefusedWithTheDifference) {
  using gs::head::Hello;
  const std::pair<std::function<void(Hello&)>, const char*> cases[] = {
      {[](Hello& h) { h.protocol_version = 2; }, "protocol version is 2; this bench needs 1"},
      {[](Hello& h) { h.sample_rate_hz = 16000; }, "sample rate in Hz is 16000; this bench needs"},
      {[](Hello& h) { h.dac_bits = 8; }, "resolution in bits is 8; this bench needs 12"},
      {[](Hello& h) { h.full_scale_mv = 500; }, "full scale is 0.5 V; the station states 1.444 V"},
      {[](Hello& h) { h.flags = 0; }, "crystal does not run"},
      {[](Hello& h) { h.counts_per_sample = 0; }, "0 counts for each sample"},
  };
  for (const auto& one : cases) {
    head().spoil_to_bench(changing<Hello>(one.first));
    EXPECT_THAT(error_of_prepare(), HasSubstr(one.second));
    ASSERT_TRUE(source().make_safe().ok());
  }
  head().spoil_to_bench({});
  EXPECT_EQ(error_of_prepare(), "");
}

TEST_F(HeadFault, OtherInstrumentOnThePortIsNoHead) {
  head().spoil_to_bench([](Bytes& frame) {
    const std::string text = "-113,\"Undefined header\"\n";
    frame.assign(text.begin(), text.end());
  });
  EXPECT_THAT(error_of_prepare(), HasSubstr("what answers is not a DAC head"));
  EXPECT_THAT(error_of(source().make_safe()), HasSubstr("output state unknown"));
}

TEST_F(HeadFault, SilentPortIsNoHead) {
  head().spoil_to_bench([](Bytes& frame) { frame.clear(); });
  EXPECT_THAT(error_of_prepare(), HasSubstr("no DAC head answers"));
}

TEST_F(HeadFault, RefusedMessageIsNamed) {
  play_some();
  // The head takes the next samples for a repetition of earlier ones.
  head().spoil_to_bench([sent = false](Bytes& frame) mutable {
    if (!sent) {
      sent = true;
      const gs::head::Refused refused{gs::head::Refusal::kPosition, 77, 78};
      Bytes bytes(gs::head::kLongestMessage);
      bytes.resize(gs::head::encode(refused, 5, bytes.data(), bytes.size()));
      frame.resize(gs::wire::kLongestFrame);
      frame.resize(gs::wire::frame(bytes.data(), bytes.size(), frame.data(), frame.size()));
    }
  });
  EXPECT_THAT(error_of_advance(),
              HasSubstr("refused message 77: its samples are not the next ones"));
}

}  // namespace
}  // namespace gsbench::test
