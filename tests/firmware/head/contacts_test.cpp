#include <head_test/rig.hpp>

#include <gtest/gtest.h>

#include <head/contacts.hpp>

namespace gs::head::test {
namespace {

class ContactsTest : public testing::Test {
 protected:
  ContactsTest() {
    contacts_.start(0b0010);
    rig_.play(4096);
    rig_.run_ms(1);
    rig_.forget();
  }

  std::vector<Edge> edges() {
    rig_.receive();
    return rig_.received<Edge>();
  }

  Rig rig_;
  Contacts contacts_{rig_.head()};
};

TEST_F(ContactsTest, StartInTheirState) {
  EXPECT_EQ(rig_.status().closed, 0b0010U);
}

TEST_F(ContactsTest, ChangeWithEachCaptureWhateverThePinIsMeanwhile) {
  contacts_.capture(0, 100, false, 0b0011);
  contacts_.capture(0, 200, false, 0b0011);  // has bounced back to closed already
  contacts_.capture(0, 300, false, 0b0011);
  contacts_.capture(1, 400, false, 0b0001);
  ASSERT_EQ(edges().size(), 4U);
  EXPECT_TRUE(edges()[0].closed);
  EXPECT_FALSE(edges()[1].closed);
  EXPECT_TRUE(edges()[2].closed);
  EXPECT_EQ(edges()[2].count, 300);
  EXPECT_EQ(edges()[3].input, 1);
  EXPECT_FALSE(edges()[3].closed);
  const Status status = rig_.status();
  EXPECT_EQ(status.closed, 0b0001U);
  EXPECT_EQ(status.edges_missed, 0U);
}

TEST_F(ContactsTest, HaveTheStateOfThePinAfterLostCaptures) {
  contacts_.capture(0, 100, true, 0b0010);  // back to open: no edge is known
  contacts_.capture(0, 200, true, 0b0011);
  ASSERT_EQ(edges().size(), 1U);
  EXPECT_TRUE(edges()[0].closed);
  EXPECT_EQ(edges()[0].count, 200);
  EXPECT_EQ(rig_.status().edges_missed, 2U);
}

TEST_F(ContactsTest, MayDifferFromThePinForLessThanAMillisecond) {
  contacts_.compare(0b0011);  // in the timer's filter
  contacts_.capture(0, 100, false, 0b0011);
  contacts_.compare(0b0010);
  contacts_.capture(0, 200, false, 0b0010);
  contacts_.compare(0b0010);
  contacts_.compare(0b0010);
  EXPECT_EQ(edges().size(), 2U);
  EXPECT_EQ(rig_.status().edges_missed, 0U);
}

TEST_F(ContactsTest, ThatDifferFromThePinForLongerHaveMissedAnEdge) {
  contacts_.compare(0b0011);
  contacts_.compare(0b0011);
  EXPECT_TRUE(edges().empty());
  const Status status = rig_.status();
  EXPECT_EQ(status.closed, 0b0011U);
  EXPECT_EQ(status.edges_missed, 1U);
  contacts_.compare(0b0011);
  contacts_.capture(0, 300, false, 0b0010);
  ASSERT_EQ(edges().size(), 1U);
  EXPECT_FALSE(edges()[0].closed);
  EXPECT_EQ(rig_.status().edges_missed, 1U);
}

}  // namespace
}  // namespace gs::head::test
