// Sessions of several centres, repeated messages, and commands that are obeyed once.
#include "endpoint_fixture.hpp"

namespace gs::app {
namespace {

// ---- sessions

TEST_F(EndpointTest, ARepeatedIdentifyIsADuplicateAndWhatFollowsItIsNotObeyedAgain) {
  send(wire::test::command(false, 1), 0);
  send(wire::test::command(true, 2), 1);
  ASSERT_TRUE(app_.relay_closed());
  const std::size_t before = listener_.received.size();
  send(downlink(DownlinkKind::kIdentify), 0xFFFFFFFFU);
  send(wire::test::command(false, 1), 0);
  send(wire::test::command(true, 2), 1);
  EXPECT_EQ(listener_.received.size(), before);
  EXPECT_EQ(status(2).messages_dropped, 3U);
}

TEST_F(EndpointTest, AMessageOfAnUnknownSessionIsRefusedUntilIdentifyBeginsIt) {
  wire::Downlink other = ping(5);
  other.session = 1234;
  send(other, 7);
  ASSERT_EQ(listener_.last().kind, UplinkKind::kError);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
  EXPECT_EQ(listener_.last().error.detail, 1234U);
  wire::Downlink identify = wire::identify();
  identify.session = 1234;
  send(identify, 7);
  EXPECT_EQ(listener_.last().hello.session, 1234U);
  send(other, 7);
  EXPECT_EQ(listener_.last().kind, UplinkKind::kHello) << "a duplicate";
  send(other, 8);
  EXPECT_EQ(listener_.last().echo.token, 5U);
  const wire::Status reported = status(0);
  EXPECT_EQ(reported.messages_dropped, 2U);
  EXPECT_EQ(reported.messages_bad, 0U);
}

TEST_F(EndpointTest, SessionsHaveNumbersAndRequestsOfTheirOwn) {
  send(wire::test::command(false, 5), 0);
  wire::Downlink other = wire::identify();
  other.session = 1234;
  send(other, 0);
  other = wire::test::command(true, 1);
  other.session = 1234;
  send(other, 1);
  EXPECT_EQ(listener_.received[listener_.received.size() - 2].command_answer.session, 1234U);
  EXPECT_TRUE(app_.relay_closed());
  send(wire::test::command(false, 6), 1);
  EXPECT_FALSE(app_.relay_closed());
}

TEST_F(EndpointTest, AFifthSessionReplacesTheOneUsedLongestAgo) {
  const auto identify = [this](std::uint32_t session) {
    wire::Downlink message = wire::identify();
    message.session = session;
    send(message, 0);
  };
  for (const std::uint32_t session : {101U, 102U, 103U}) {
    identify(session);
  }
  send(ping(1), 0);  // the fixture's session is now used last
  identify(104);
  send(ping(2), 1);
  EXPECT_EQ(listener_.last().echo.token, 2U);
  wire::Downlink late = ping(3);
  late.session = 101;
  send(late, 1);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
  late.session = 102;
  send(late, 1);
  EXPECT_EQ(listener_.last().echo.token, 3U);
}

TEST_F(EndpointTest, ACommandOfASessionThatWasReplacedIsNotObeyedAgain) {
  const auto identify = [this](std::uint32_t session) {
    wire::Downlink message = wire::identify();
    message.session = session;
    send(message, 0);
  };
  send(wire::test::command(false, 1), 0);
  send(wire::test::command(true, 2), 1);
  for (const std::uint32_t session : {101U, 102U, 103U, 104U}) {
    identify(session);
  }
  send(wire::test::command(false, 1), 2);
  ASSERT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
  identify(wire::test::kSession);
  send(wire::test::command(false, 1), 1);
  EXPECT_TRUE(app_.relay_closed());
  EXPECT_EQ(listener_.last().command_answer.request, 1U);
  send(wire::test::command(false, 3), 2);
  EXPECT_FALSE(app_.relay_closed());
}

TEST_F(EndpointTest, TheRequestsOf16SessionsThatWereReplacedLastAreRemembered) {
  // Opens and closes, as requests 1 and 2 of this session.
  const auto move_relay = [this](std::uint32_t session, std::uint32_t first_number) {
    wire::Downlink message = wire::identify();
    message.session = session;
    send(message, first_number);
    const std::size_t before = listener_.received.size();
    for (const std::uint32_t request : {1U, 2U}) {
      message = wire::test::command(request == 2, request);
      message.session = session;
      send(message, first_number + request);
    }
    return listener_.received.size() - before - 2;  // relay messages
  };
  constexpr std::uint32_t kFirst = 1000;
  constexpr std::uint32_t kLast = kFirst + kSessions + kPastSessions;  // the first one is forgotten
  for (std::uint32_t session = kFirst; session <= kLast; ++session) {
    EXPECT_EQ(move_relay(session, 0), 2U) << session;
  }
  EXPECT_EQ(move_relay(kFirst + 1, 5), 0U);
  EXPECT_EQ(move_relay(kFirst + 3, 5), 0U);
  EXPECT_EQ(move_relay(kFirst, 5), 2U);
}

TEST_F(EndpointTest, AMessageOfAnUnknownKindUsesUpItsNumber) {
  const Bytes unknown = {0x83, 0x18, 0x63, 0x00, 0x18, wire::test::kSession};
  send(unknown);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownKind);
  const std::size_t before = listener_.received.size();
  send(unknown);
  send(ping(1), 0);
  EXPECT_EQ(listener_.received.size(), before) << "duplicates";
  Bytes of_another = unknown;
  of_another.back() = wire::test::kSession + 1;
  send(of_another);
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kUnknownSession);
}

// ---- commands

TEST_F(EndpointTest, ARepeatedRequestIsAnsweredButNotObeyedAgain) {
  send(wire::test::command(false, 3), 0);
  send(wire::test::command(true, 4), 1);
  std::uint32_t sequence = 2;
  for (const std::uint32_t request : {3U, 4U, 1U}) {
    const std::size_t before = listener_.received.size();
    send(wire::test::command(false, request), sequence++);
    ASSERT_EQ(listener_.received.size(), before + 1) << "an answer, and no relay message";
    EXPECT_EQ(listener_.last().command_answer.request, request);
    EXPECT_TRUE(listener_.last().command_answer.closed);
  }
  EXPECT_EQ(status(100).messages_dropped, 0U);
}

TEST_F(EndpointTest, ACommandForAnotherStartIsRefused) {
  wire::Downlink command = wire::test::command(false, 8);
  command.start_number = app_.start_number() + 1;
  send(command, 0);
  EXPECT_TRUE(app_.relay_closed());
  EXPECT_EQ(listener_.last().error.code, ErrorCode::kOtherStart);
  EXPECT_EQ(listener_.last().error.detail, 8U);
  command.start_number = app_.start_number();
  send(command, 1);
  EXPECT_FALSE(app_.relay_closed()) << "the refused request was not used up";
  EXPECT_EQ(status(2).messages_dropped, 1U);
}

}  // namespace
}  // namespace gs::app
