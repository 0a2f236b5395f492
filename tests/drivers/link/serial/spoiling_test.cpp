// Lines that flip, drop, double and reorder bytes: told, and nothing wrong is taken for right.
#include "outlets_on_cables.hpp"
#include "spoilers.hpp"

#include <ostream>
#include <utility>

namespace {

using gs::wire::UplinkKind;
using gsbench::test::Bytes;
using gsbench::test::double_a_byte;
using gsbench::test::drop_a_byte;
using gsbench::test::each_message;
using gsbench::test::every_nth_byte;
using gsbench::test::flip_a_bit;
using gsbench::test::OutletsOnCables;
using gsbench::test::reorder_two_bytes;
using testing::IsEmpty;

struct Spoiling {
  const char* name;
  void (*spoil)(Bytes& bytes);
};

void PrintTo(const Spoiling& spoiling, std::ostream* out) {
  *out << spoiling.name;
}

class SpoiledLine : public OutletsOnCables, public testing::WithParamInterface<Spoiling> {
 protected:
  // What an outlet on mains without a voltage says: an invalid measurement every 128 samples,
  // counted from its start. Anything else was made up by the line.
  void expect_only_true_measurements(std::size_t outlet) const {
    std::uint64_t last = 0;
    for (const auto& received : messages(outlet, UplinkKind::kMeasurement)) {
      EXPECT_GT(received.message.sample, last);
      EXPECT_EQ(received.message.sample % 128, 0U);
      EXPECT_EQ(received.message.measurement.voltage_pu, 0.0F);
      EXPECT_EQ(received.message.measurement.validity, gs::outlet::Validity::kInvalid);
      last = received.message.sample;
    }
    for (const auto& received : messages_) {
      // A hello more than one where the first took long.
      EXPECT_TRUE(received.message.kind == UplinkKind::kMeasurement ||
                  received.message.kind == UplinkKind::kEcho ||
                  received.message.kind == UplinkKind::kHello)
          << to_string(received.message.kind);
    }
  }
};

TEST_P(SpoiledLine, IsToldAndNothingWrongIsTakenForRight) {
  constexpr std::size_t kReports = 300;
  add("spoiled");
  add("other");
  open();
  // In one of about three messages, at another place in each.
  outlets_[0].cable->spoil(every_nth_byte(97, GetParam().spoil));
  for (std::size_t i = 0; i < kReports / 10; ++i) {
    play(0, 10);
    play(1, 10);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_TRUE(until([&] { return messages(1, UplinkKind::kMeasurement).size() >= kReports; }));
  EXPECT_TRUE(until([&] { return told(0, "sent a damaged frame"); }));
  outlets_[0].cable->spoil({});
  // The first message after a spoiled one may go with it.
  send(0, ping(1));
  EXPECT_TRUE(answers(0, 2));
  EXPECT_TRUE(told(0, " of its messages were lost before its sample ")) << "by their numbers";
  const std::size_t came = messages(0, UplinkKind::kMeasurement).size();
  EXPECT_LT(came, kReports);
  EXPECT_GT(came, kReports / 4) << "most messages are whole";
  expect_only_true_measurements(0);
  expect_only_true_measurements(1);
  EXPECT_THAT(faults(1), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpoiledLine,
                         testing::Values(Spoiling{"FlippedBits", flip_a_bit},
                                         Spoiling{"DroppedBytes", drop_a_byte},
                                         Spoiling{"DoubledBytes", double_a_byte},
                                         Spoiling{"ReorderedBytes", reorder_two_bytes}),
                         [](const auto& kind) { return kind.param.name; });

using RepeatingLine = OutletsOnCables;

TEST_F(RepeatingLine, DoubledMessagesComeOnce) {
  add("a");
  open();
  outlets_[0].cable->spoil(each_message([](const Bytes& message) {
    return std::vector<Bytes>{message, message};
  }));
  play(0, 50);
  ASSERT_TRUE(answers(0, 1));
  EXPECT_EQ(messages(0, UplinkKind::kEcho).size(), 1U);
  EXPECT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= 50; }));
  EXPECT_EQ(messages(0, UplinkKind::kMeasurement).size(), 50U);
  EXPECT_THAT(faults_, IsEmpty());
}

TEST_F(RepeatingLine, ReorderedMessagesAreToldAndTheLateOneIsLeftOut) {
  add("a");
  open();
  auto held = std::make_shared<Bytes>();
  outlets_[0].cable->spoil(each_message([held](const Bytes& message) {
    if (held->empty()) {
      *held = message;
      return std::vector<Bytes>{};
    }
    const Bytes late = std::exchange(*held, {});
    return std::vector<Bytes>{message, late};
  }));
  play(0, 50);
  EXPECT_TRUE(until([&] { return messages(0, UplinkKind::kMeasurement).size() >= 25; }));
  EXPECT_TRUE(told(0, "1 of its messages were lost before its sample "));
  std::uint64_t last = 0;
  for (const auto& received : messages(0, UplinkKind::kMeasurement)) {
    EXPECT_GT(received.message.sample, last);
    last = received.message.sample;
  }
}

}  // namespace
