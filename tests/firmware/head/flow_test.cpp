// Numbers, gaps, repetition, flow control and status.
#include <head_test/rig.hpp>

#include <deque>
#include <random>

#include <gtest/gtest.h>

namespace gs::head::test {
namespace {

Refused only_refusal(Rig& rig) {
  rig.receive();
  const auto refused = rig.received<Refused>();
  EXPECT_EQ(refused.size(), 1U);
  rig.forget();
  return refused.empty() ? Refused{} : refused.front();
}

TEST(Session, BeginsWithAHello) {
  Rig rig;
  rig.receive();
  ASSERT_EQ(rig.received_bytes().size(), 1U);
  const auto hello = rig.received<Hello>();
  ASSERT_EQ(hello.size(), 1U);
  EXPECT_EQ(hello[0].protocol_version, 1);
  EXPECT_STREQ(hello[0].board, "stm32f405");
  EXPECT_EQ(hello[0].unique_id[11], 0xAB);
  EXPECT_EQ(hello[0].build, 0xDEADBEEFU);
  EXPECT_EQ(hello[0].flags, kCrystalRuns);
  EXPECT_EQ(hello[0].full_scale, kFullScale);
  EXPECT_EQ(hello[0].counts_per_sample, kCountsPerSample);
  rig.send(Identify{});
  rig.receive();
  EXPECT_EQ(rig.received<Hello>().size(), 2U);
}

TEST(Session, NumbersTheHeadsMessages) {
  Rig rig;
  rig.receive();
  rig.play(256);
  rig.run_ms(50);
  Header header;
  for (std::size_t i = 0; i < rig.received_bytes().size(); ++i) {
    const Bytes& bytes = rig.received_bytes()[i];
    ASSERT_TRUE(decode_header(bytes.data(), bytes.size(), header));
    // 0: the hello at start-up, 1: that for identify, 2: the status for arm.
    EXPECT_EQ(header.number, i + 3);
  }
  EXPECT_GT(header.number, 5U);
}

TEST(Session, AcceptsNothingElseBeforeAnIdentify) {
  Rig rig;
  rig.send(Arm{1}, 0);
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kNotIdentified);
  rig.send(stream(0, 1), 0);
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kNotIdentified);
  rig.send(Stop{}, 0);
  rig.ping(5);
  rig.receive();
  EXPECT_TRUE(rig.received<Refused>().empty());
  EXPECT_EQ(rig.received<Status>().back().echo, 5U);
}

TEST(Session, OfAnotherVersionIsRefused) {
  Rig rig;
  rig.receive();
  rig.send(Identify{2});
  rig.receive();
  EXPECT_EQ(rig.received<Hello>().size(), 2U);
  rig.forget();
  rig.send(Arm{1});
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kVersion);
  rig.set_number(9);
  rig.send(Identify{});
  rig.send(Arm{1});
  EXPECT_EQ(rig.status().state, State::kArmed);
}

TEST(Session, OfALaterVersionIsRecognisedWhateverFollows) {
  Rig rig;
  rig.receive();
  Bytes bytes = encoded(Identify{2}, 4);
  bytes.insert(bytes.end(), {1, 2, 3});
  rig.send(bytes);
  rig.receive();
  EXPECT_EQ(rig.received<Hello>().size(), 2U);
  EXPECT_TRUE(rig.received<Refused>().empty());
}

TEST(Numbers, CountOnFromIdentifyAcrossTheirWrap) {
  Rig rig;
  rig.set_number(0xFFFFFFFEU);
  rig.send(Identify{});
  rig.send(Arm{1});
  rig.send(stream(0, 10));
  rig.send(stream(10, 10));
  rig.receive();
  EXPECT_TRUE(rig.received<Refused>().empty());
  EXPECT_EQ(rig.status().expected, 2U);
  EXPECT_EQ(rig.status().room, kBufferSamples - 20);
}

TEST(Numbers, AGapIsRefusedAndNamesTheExpectedNumber) {
  Rig rig;
  rig.arm();
  rig.send(stream(0, 10), 2);
  rig.send(stream(20, 10), 4);
  const Refused refused = only_refusal(rig);
  EXPECT_EQ(refused.reason, Refusal::kGap);
  EXPECT_EQ(refused.refused, 4U);
  EXPECT_EQ(refused.expected, 3U);
  EXPECT_EQ(rig.status().room, kBufferSamples - 10);
}

TEST(Numbers, AGapIsReportedOnceUntilTheNextStatusOrAcceptedMessage) {
  Rig rig;
  rig.arm();
  for (std::uint32_t number = 3; number < 20; ++number) {
    rig.send(stream(0, 10), number);
  }
  EXPECT_EQ(only_refusal(rig).refused, 3U);
  rig.run_ms(8);  // a status
  rig.forget();
  rig.send(stream(0, 10), 20);
  EXPECT_EQ(only_refusal(rig).refused, 20U);
  rig.send(stream(0, 10), 2);
  rig.send(stream(0, 10), 7);
  EXPECT_EQ(only_refusal(rig).expected, 3U);
}

TEST(Numbers, ARepeatedMessageIsIgnoredAndAnsweredByAStatus) {
  Rig rig;
  rig.arm();
  rig.send(stream(0, 10));
  rig.receive();
  rig.forget();
  rig.send(stream(0, 10), 2);
  rig.send(stream(500, 10), rig.number() - 0x80000000U);
  rig.receive();
  EXPECT_TRUE(rig.received<Refused>().empty());
  ASSERT_EQ(rig.received<Status>().size(), 1U);
  EXPECT_EQ(rig.received<Status>()[0].room, kBufferSamples - 10);
  EXPECT_EQ(rig.received<Status>()[0].expected, 3U);
}

TEST(Numbers, APingReportsTheLossOfTheMessageBeforeIt) {
  Rig rig;
  rig.arm();
  rig.set_number(rig.number() + 1);
  rig.ping(77);
  const Refused refused = only_refusal(rig);
  EXPECT_EQ(refused.reason, Refusal::kGap);
  EXPECT_EQ(refused.expected, 2U);
}

TEST(Numbers, ARefusedMessageDoesNotUseItsNumber) {
  Rig rig;
  rig.arm();
  rig.send(stream(5, 10), 2);
  EXPECT_EQ(only_refusal(rig).expected, 2U);
  rig.send(stream(0, 10), 2);
  EXPECT_EQ(rig.status().expected, 3U);
}

TEST(Refusals, HaveTheirReasons) {
  struct Case {
    Refusal reason;
    Bytes message;
  };
  const std::uint32_t next = 2;
  Bytes long_arm = encoded(Arm{1}, next);
  long_arm.push_back(0);
  Bytes short_samples = encoded(stream(0, 10), next);
  short_samples.pop_back();
  Bytes long_samples = encoded(stream(0, 10), next);
  long_samples.push_back(0);
  Bytes no_samples = encoded(stream(0, 1), next);
  no_samples.resize(kHeadLength + 10);
  no_samples[kHeadLength + 8] = 0;
  const std::vector<Case> cases = {
      {Refusal::kMalformed, long_arm},
      {Refusal::kMalformed, short_samples},
      {Refusal::kMalformed, long_samples},
      {Refusal::kMalformed, no_samples},
      {Refusal::kUnknownKind, {0x08, 2, 0, 0, 0}},
      {Refusal::kUnknownKind, encoded(Refused{}, next)},
      {Refusal::kState, encoded(Arm{1}, next)},
      {Refusal::kPosition, encoded(stream(1, 10), next)},
      {Refusal::kRange, encoded(samples_message(0, {0, kFullScale + 1}), next)},
      {Refusal::kRange, encoded(samples_message(0, {-kFullScale - 1}), next)},
      {Refusal::kRange, encoded(samples_message(0, {-32768}), next)},
      {Refusal::kRange, encoded(Play{0}, next)},
      {Refusal::kRange, encoded(Play{kBufferSamples + 1}, next)},
      {Refusal::kNotKept, encoded(ResendEdges{1}, next)}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    Rig rig;
    rig.arm();
    rig.send(cases[i].message);
    const Refused refused = only_refusal(rig);
    EXPECT_EQ(refused.reason, cases[i].reason) << i;
    EXPECT_EQ(refused.refused, next) << i;
    EXPECT_EQ(refused.expected, next) << i;
    const Status status = rig.status();
    EXPECT_EQ(status.state, State::kArmed) << i;
    EXPECT_EQ(status.room, kBufferSamples) << i;
  }
}

TEST(Refusals, OfSamplesAndPlayWhileOff) {
  Rig rig;
  rig.send(Identify{});
  rig.send(stream(0, 10), 1);
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kState);
  rig.send(Play{1}, 1);
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kState);
}

TEST(Refusals, OfMessagesThatAreTooShortHaveNoNumber) {
  Rig rig;
  rig.arm();
  rig.send(Bytes{0x05, 0, 0, 0});
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kMalformed);
}

TEST(Refusals, WaitEightAtMost) {
  Rig rig;
  rig.arm();
  for (int i = 0; i < 100; ++i) {
    rig.send(Bytes{0x77, 0, 0, 0, 0});
  }
  rig.receive();
  EXPECT_EQ(rig.received<Refused>().size(), 8U);
}

TEST(Flow, TakesExactlyAsManySamplesAsThereIsRoomFor) {
  Rig rig;
  rig.arm();
  for (std::uint64_t first = 0; first < kBufferSamples; first += 256) {
    rig.send(stream(first, 256));
  }
  EXPECT_EQ(rig.status().room, 0U);
  rig.forget();
  rig.send(stream(kBufferSamples, 1), rig.number());
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kNoRoom);
  rig.send(Play{kBufferSamples});
  rig.run_ms(10);
  // The next sample is taken with the second code of each sample, the first one at the beginning.
  EXPECT_EQ(rig.status().room, 81U);
  rig.forget();
  rig.send(stream(kBufferSamples, 82), rig.number());
  EXPECT_EQ(only_refusal(rig).reason, Refusal::kNoRoom);
  rig.send(stream(kBufferSamples, 81));
  EXPECT_EQ(rig.status().room, 0U);
}

TEST(Status, IsSentEveryEightMillisecondsWhileArmedAndPlaying) {
  Rig rig;
  rig.arm();
  rig.run_ms(80);
  EXPECT_EQ(rig.received<Status>().size(), 10U);
  rig.send(stream(0, 256));
  rig.send(stream(256, 256));
  rig.send(Play{512});
  rig.run_ms(1);
  rig.forget();
  rig.run_ms(48);
  const auto playing = rig.received<Status>();
  ASSERT_EQ(playing.size(), 6U);
  for (std::size_t i = 1; i < playing.size(); ++i) {
    EXPECT_EQ(playing[i].position - playing[i - 1].position, 64U);
    EXPECT_EQ(playing[i].count - playing[i - 1].count, 64 * std::int64_t{kCountsPerSample});
    EXPECT_EQ(playing[i].state, State::kPlaying);
    EXPECT_EQ(playing[i].run, 7U);
  }
  rig.send(Stop{});
  rig.run_ms(1);
  rig.forget();
  rig.run_ms(100);
  EXPECT_TRUE(rig.received<Status>().empty());
}

TEST(Status, IsSentAtOnceWhenPlayBeginsAndWhenItFails) {
  Rig rig;
  rig.play(10);
  rig.receive();
  rig.forget();
  rig.run_ms(1);
  ASSERT_EQ(rig.received<Status>().size(), 1U);
  EXPECT_EQ(rig.received<Status>()[0].state, State::kPlaying);
  rig.forget();
  rig.run_ms(1);
  ASSERT_EQ(rig.received<Status>().size(), 1U);
  EXPECT_EQ(rig.received<Status>()[0].state, State::kFaulted);
  EXPECT_EQ(rig.received<Status>()[0].fault, Fault::kUnderrun);
}

TEST(Status, ContainsTheTokenOfThePing) {
  Rig rig;
  rig.arm();
  rig.ping(0xCAFE0001U);
  rig.receive();
  ASSERT_EQ(rig.received<Status>().size(), 1U);
  EXPECT_EQ(rig.received<Status>()[0].echo, 0xCAFE0001U);
}

TEST(Status, CountsFromSample0AtTheOutput) {
  Rig rig;
  rig.run_ms(5);
  rig.play(4096);
  EXPECT_EQ(rig.status().count, 0);
  rig.run_ms(3);
  EXPECT_EQ(rig.status().count, 3 * 8 * std::int64_t{kCountsPerSample});
}

TEST(Status, CountsBadFrames) {
  Rig rig;
  rig.head().bad_frame();
  rig.head().bad_frame();
  EXPECT_EQ(rig.status().bad_frames, 2U);
}

// Go-back-N over a line that loses, repeats and delays messages: what is played is the stream.
class LossyLine {
 public:
  LossyLine(unsigned seed, double lost) : random_(seed), lost_(lost) {}

  void run(std::size_t ms) {
    rig_.arm();
    base_ = rig_.number();
    rig_.forget();
    for (std::size_t i = 0; i < ms; ++i) {
      send_what_fits();
      deliver();
      rig_.run_ms(1);
      hear();
    }
  }
  Rig& rig() { return rig_; }
  int gaps() const { return gaps_; }

 private:
  static constexpr std::uint16_t kCount = 40;
  static constexpr std::uint32_t kPlayAt = 20;  // message number kPlayAt is `play`

  bool chance(double probability) {
    return std::uniform_real_distribution<>()(random_) < probability;
  }

  Bytes message(std::uint32_t index) const {
    const std::uint32_t number = base_ + index;
    if (index == kPlayAt) {
      return encoded(Play{kCount * kPlayAt}, number);
    }
    const std::uint32_t before = index > kPlayAt ? index - 1 : index;
    return encoded(stream(std::uint64_t{before} * kCount, kCount), number);
  }

  void send_what_fits() {
    while (std::uint64_t{next_} * kCount < position_ + 3000) {
      line_.push_back(message(next_++));
    }
    line_.push_back(encoded(Ping{}, base_ + next_));
  }

  void deliver() {
    // Up to two messages stay on the line.
    while (line_.size() > 2 || (!line_.empty() && chance(0.5))) {
      if (!chance(lost_)) {
        rig_.send(line_.front());
        if (chance(lost_)) {
          rig_.send(line_.front());
        }
      }
      line_.pop_front();
    }
  }

  void hear() {
    for (const Refused& refused : rig_.received<Refused>()) {
      ASSERT_EQ(refused.reason, Refusal::kGap);
      ++gaps_;
      if (!chance(lost_)) {
        next_ = refused.expected - base_;
      }
    }
    for (const Status& status : rig_.received<Status>()) {
      position_ = status.position;
    }
    rig_.forget();
  }

  Rig rig_;
  std::mt19937 random_;
  double lost_;
  std::uint32_t base_ = 0;
  std::uint32_t next_ = 0;
  std::uint64_t position_ = 0;
  std::deque<Bytes> line_;
  int gaps_ = 0;
};

TEST(Flow, OverALossyLineThePlayedStreamIsComplete) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    LossyLine line(seed, 0.05);
    line.run(2000);
    EXPECT_EQ(line.rig().head().state(), State::kPlaying);
    EXPECT_GT(line.gaps(), 10);
    const auto& codes = line.rig().codes();
    std::size_t begin = 0;
    while (begin < codes.size() && codes[begin] == kMidScale) {
      begin += kBlockCodes;
    }
    ASSERT_LT(begin, codes.size() / 2);
    const std::vector<std::uint16_t> played(codes.begin() + static_cast<std::ptrdiff_t>(begin),
                                            codes.end());
    EXPECT_EQ(played, codes_of_stream(played.size()));
  }
}

}  // namespace
}  // namespace gs::head::test
