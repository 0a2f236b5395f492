// Several links combined, and wait_for_outlets() on them.
#include <memory>

#include <gmock/gmock.h>

#include <link/combined_link.hpp>
#include <link/wait_for_outlets.hpp>

namespace gsbench::link {
namespace {

using namespace std::chrono_literals;
using gs::wire::Downlink;
using testing::ElementsAre;
using testing::IsEmpty;

// A link whose outlets join at the first poll; at each later poll each outlet sends a message and
// has a fault.
class Scripted final : public Link {
 public:
  Scripted(std::vector<OutletPresence> outlets, std::vector<std::string>& sent, bool refused)
      : outlets_(std::move(outlets)), sent_(sent), refused_(refused) {}
  drivers::Status open() override {
    if (refused_) {
      return drivers::Error{"not now"};
    }
    return drivers::Done{};
  }
  drivers::Status send(const std::string& id, const Downlink&) override {
    sent_.push_back(id);
    return drivers::Done{};
  }
  drivers::Status poll(Happenings& happenings) override {
    for (const OutletPresence& outlet : outlets_) {
      if (!joined_) {
        happenings.changes.emplace_back(outlet);
      } else {
        happenings.messages.push_back({outlet.id, {}, 0});
        happenings.faults.push_back({outlet.id, "of " + outlet.id});
      }
    }
    joined_ = true;
    return drivers::Done{};
  }
  std::vector<Fault> missing() override { return {{"absent", "is not on scripted"}}; }
  std::vector<Fault> unreachable() override { return {{"port", "cannot be reached"}}; }
  void close() noexcept override {}

 private:
  std::vector<OutletPresence> outlets_;
  std::vector<std::string>& sent_;
  bool refused_;
  bool joined_ = false;
};

class TwoLinks : public testing::Test {
 protected:
  void wait(std::vector<OutletPresence> first, std::vector<OutletPresence> second,
            const std::vector<std::string>& named, std::chrono::milliseconds patience = 0ms,
            std::chrono::milliseconds others_for = 0ms) {
    std::vector<std::unique_ptr<Link>> links;
    links.push_back(std::make_unique<Scripted>(std::move(first), sent_to_first_, false));
    links.push_back(std::make_unique<Scripted>(std::move(second), sent_to_second_, refused_));
    link_ = std::make_unique<CombinedLink>(std::move(links));
    auto waited = wait_for_outlets(*link_, named, patience, others_for);
    EXPECT_EQ(waited.ok(), !refused_);
    if (waited.ok()) {
      present_ = waited.take();
    }
  }
  std::vector<std::string> found() const {
    std::vector<std::string> all;
    for (const OutletPresence& outlet : present_) {
      all.push_back(outlet.id + (outlet.fault.empty() ? "" : ": " + outlet.fault));
    }
    return all;
  }

  bool refused_ = false;  // the second link cannot be opened
  std::vector<std::string> sent_to_first_;
  std::vector<std::string> sent_to_second_;
  std::unique_ptr<CombinedLink> link_;
  std::vector<OutletPresence> present_;
};

TEST_F(TwoLinks, AreCombinedByTheIdsOfTheirOutlets) {
  wait({{"a", "port 1", {}}, {"b", "port 2", {}}}, {{"c", "broker", {}}}, {"c", "port 1"});
  EXPECT_THAT(found(), ElementsAre("c", "a"));
  EXPECT_EQ(present_[0].where, "broker");
  for (const char* const id : {"c", "b"}) {
    EXPECT_TRUE(link_->send(id, {}).ok());
  }
  EXPECT_FALSE(link_->send("d", {}).ok());
  EXPECT_THAT(sent_to_first_, ElementsAre("b"));
  EXPECT_THAT(sent_to_second_, ElementsAre("c"));
  Happenings happenings;
  ASSERT_TRUE(link_->poll(happenings).ok());
  ASSERT_EQ(happenings.messages.size(), 3U);
  EXPECT_EQ(happenings.messages[2].id, "c");
  ASSERT_EQ(happenings.faults.size(), 3U);
  EXPECT_EQ(happenings.faults[2].what, "of c");
  EXPECT_EQ(link_->unreachable().size(), 2U);
}

TEST_F(TwoLinks, ReportTheSameIdOnBothLinksAsAFaultOfBothOutlets) {
  wait({{"a", "port 1", {}}, {"twin", "port 2", {}}}, {{"twin", "broker", {}}, {"c", "broker", {}}},
       {"port 1", "port 2", "twin", "c"});
  EXPECT_THAT(
      found(),
      ElementsAre("a", "twin on port 2: has the same id as another outlet: the one on broker",
                  "twin on broker: has the same id as another outlet: the one on port 2", "c"));
}

TEST_F(TwoLinks, AreWaitedForWhileSomethingElseIsKeptGoing) {
  wait({{"a", "port 1", {}}}, {}, {"a"});
  std::vector<std::size_t> joined;
  const auto meanwhile = [&](std::size_t count) -> drivers::Status {
    joined.push_back(count);
    return joined.size() < 3 ? drivers::Status(drivers::Done{}) : drivers::Error{"tripped"};
  };
  const auto waited = wait_on_open_link(*link_, {"a", "b"}, std::chrono::hours(1), 0ms, meanwhile);
  ASSERT_FALSE(waited.ok());
  EXPECT_EQ(waited.error(), "tripped");
  EXPECT_EQ(joined.size(), 3U);
}

TEST_F(TwoLinks, CannotBeOpenedIfOneOfThemCannot) {
  refused_ = true;
  wait({{"a", "port 1", {}}}, {}, {"a"});
  EXPECT_THAT(present_, IsEmpty());
  EXPECT_FALSE(link_->send("a", {}).ok());
}

TEST_F(TwoLinks, PassOnTheFaultsThatOneOfThemReports) {
  wait({{"a", "port 1", {}, "uses protocol version 1"}}, {}, {"a"});
  EXPECT_THAT(found(), ElementsAre("a: uses protocol version 1"));
}

TEST_F(TwoLinks, AreWaitedForUntilTheTimeLimit) {
  const auto begin = std::chrono::steady_clock::now();
  wait({{"a", "port 1", {}}}, {}, {"a", "b", "absent"}, 100ms);
  EXPECT_GE(std::chrono::steady_clock::now() - begin, 100ms);
  EXPECT_THAT(found(), ElementsAre("a", "b: does not answer", "absent: is not on scripted"));
}

// Joins at the first poll, leaves at the second, and is excluded half a second later, which is
// after the usual wait.
class Leaving final : public Link {
 public:
  drivers::Status open() override { return drivers::Done{}; }
  drivers::Status send(const std::string&, const Downlink&) override { return drivers::Done{}; }
  drivers::Status poll(Happenings& happenings) override {
    ++polls_;
    if (polls_ == 1) {
      happenings.changes.emplace_back(OutletPresence{"a", "broker", {}});
    } else if (polls_ == 2) {
      happenings.changes.emplace_back(Fault{"a", "left the broker", "broker"});
    } else if (polls_ == 250) {
      happenings.changes.emplace_back(Fault{"a", "is one of two", "broker", true});
    }
    return drivers::Done{};
  }
  void close() noexcept override {}

 private:
  int polls_ = 0;
};

TEST(WaitForOutlets, OneThatLeavesMeanwhileIsWatchedUntilTheTimeLimit) {
  Leaving link;
  const auto present = wait_for_outlets(link, {"a"}, 2s);
  ASSERT_TRUE(present.ok());
  ASSERT_EQ(present.value().size(), 1U);
  EXPECT_EQ(present.value()[0].fault, "is one of two");
}

// As a broker says when another connection of the same client takes the place of the first.
class LeavingAndReturning final : public Link {
 public:
  drivers::Status open() override { return drivers::Done{}; }
  drivers::Status send(const std::string&, const Downlink&) override { return drivers::Done{}; }
  drivers::Status poll(Happenings& happenings) override {
    const OutletPresence here{"a", "broker", {}};
    const Fault left{"a", "left the broker", "broker"};
    ++polls_;
    if (polls_ == 1) {
      happenings.changes = {here};
    } else if (polls_ == 2) {
      happenings.changes = {left, here};
    }
    return drivers::Done{};
  }
  void close() noexcept override {}

 private:
  int polls_ = 0;
};

TEST(WaitForOutlets, OneThatLeavesAndReturnsAtOnceIsThere) {
  LeavingAndReturning link;
  const auto present = wait_for_outlets(link, {"a"}, 300ms);
  ASSERT_TRUE(present.ok());
  ASSERT_EQ(present.value().size(), 1U);
  EXPECT_EQ(present.value()[0].fault, "");
}

// It was plugged into another port meanwhile.
class Moving final : public Link {
 public:
  drivers::Status open() override { return drivers::Done{}; }
  drivers::Status send(const std::string&, const Downlink&) override { return drivers::Done{}; }
  drivers::Status poll(Happenings& happenings) override {
    if (!moved_) {
      happenings.changes = {OutletPresence{"a", "port 1", {}},
                            Fault{"a", "was unplugged from port 1", "port 1"},
                            OutletPresence{"a", "port 2", {}}};
    }
    moved_ = true;
    return drivers::Done{};
  }
  void close() noexcept override {}

 private:
  bool moved_ = false;
};

TEST(WaitForOutlets, OneThatHasLeftIsNoTwin) {
  Moving link;
  const auto present = wait_for_outlets(link, {"port 1", "port 2"}, 300ms);
  ASSERT_TRUE(present.ok());
  ASSERT_EQ(present.value().size(), 2U);
  EXPECT_EQ(present.value()[0].fault, "was unplugged from port 1");
  EXPECT_EQ(present.value()[1].fault, "");
}

TEST_F(TwoLinks, ReturnAllOutletsIfOthersAreWanted) {
  wait({{"a", "port 1", {}}}, {{"c", "broker", {}}}, {"c"}, 0ms, 1ms);
  EXPECT_THAT(found(), ElementsAre("c", "a", "absent: is not on scripted"));
}

}  // namespace
}  // namespace gsbench::link
