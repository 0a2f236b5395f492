// Several links as one.
#include <cstdio>
#include <memory>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <link/combined_link.hpp>

namespace {

using gs::wire::Downlink;
using gs::wire::Uplink;
using gsbench::link::CombinedLink;
using gsbench::link::Fault;
using gsbench::link::Link;
using gsbench::link::OutletPresence;
using gsbench::link::Received;
using testing::ElementsAre;
using testing::IsEmpty;

// Has these outlets; each says one message and has one fault at every poll.
class Scripted final : public Link {
 public:
  Scripted(std::vector<OutletPresence> outlets, std::vector<std::size_t>& sent, bool refused)
      : outlets_(std::move(outlets)), sent_(sent), refused_(refused) {}
  std::string name() const override { return "scripted"; }
  gsbench::drivers::Result<std::vector<OutletPresence>> open() override {
    if (refused_) {
      return gsbench::drivers::Error{"not now"};
    }
    return outlets_;
  }
  gsbench::drivers::Status send(std::size_t outlet, const Downlink&) override {
    sent_.push_back(outlet);
    return gsbench::drivers::Done{};
  }
  gsbench::drivers::Status poll(std::vector<Received>& messages,
                                std::vector<Fault>& faults) override {
    for (std::size_t i = 0; i < outlets_.size(); ++i) {
      messages.push_back({i, Uplink(), 0});
      faults.push_back({i, "of " + outlets_[i].id});
    }
    return gsbench::drivers::Done{};
  }
  void close() noexcept override {}

 private:
  std::vector<OutletPresence> outlets_;
  std::vector<std::size_t>& sent_;
  bool refused_;
};

OutletPresence outlet(const char* id, const char* where) {
  OutletPresence present{id, where, {}};
  gs::wire::Hello& hello = present.hello;
  std::snprintf(hello.id, sizeof hello.id, "%s", id);
  return present;
}

class TwoLinks : public testing::Test {
 protected:
  void open(std::vector<OutletPresence> first, std::vector<OutletPresence> second) {
    std::vector<std::unique_ptr<Link>> links;
    links.push_back(std::make_unique<Scripted>(std::move(first), sent_to_first_, false));
    links.push_back(std::make_unique<Scripted>(std::move(second), sent_to_second_, refused_));
    link_ = std::make_unique<CombinedLink>(std::move(links));
    auto opened = link_->open();
    EXPECT_EQ(opened.ok(), !refused_);
    if (opened.ok()) {
      present_ = opened.take();
    }
  }

  bool refused_ = false;  // by the second
  std::vector<std::size_t> sent_to_first_;
  std::vector<std::size_t> sent_to_second_;
  std::unique_ptr<CombinedLink> link_;
  std::vector<OutletPresence> present_;
};

TEST_F(TwoLinks, AreOneInTheirOrder) {
  open({outlet("a", "port 1"), outlet("b", "port 2")}, {outlet("c", "broker")});
  ASSERT_EQ(present_.size(), 3U);
  EXPECT_EQ(present_[2].id, "c");
  EXPECT_EQ(present_[2].where, "broker");
  for (const std::size_t outlet : {2U, 0U}) {
    EXPECT_TRUE(link_->send(outlet, {}).ok());
  }
  EXPECT_FALSE(link_->send(3, {}).ok());
  EXPECT_THAT(sent_to_first_, ElementsAre(0));
  EXPECT_THAT(sent_to_second_, ElementsAre(0));
  std::vector<Received> messages;
  std::vector<Fault> faults;
  ASSERT_TRUE(link_->poll(messages, faults).ok());
  ASSERT_EQ(messages.size(), 3U);
  ASSERT_EQ(faults.size(), 3U);
  EXPECT_EQ(messages[2].outlet, 2U);
  EXPECT_EQ(faults[2].outlet, 2U);
  EXPECT_EQ(faults[2].what, "of c");
}

TEST_F(TwoLinks, WithAnOutletOfOneIdOnEachSpeakWithTheOthersAlone) {
  open({outlet("a", "port 1"), outlet("twin", "port 2")},
       {outlet("twin", "broker"), outlet("c", "broker")});
  EXPECT_EQ(present_[1].id, "twin on port 2");
  EXPECT_EQ(present_[1].fault, "is there twice: the one on broker says that it is it");
  EXPECT_EQ(present_[2].id, "twin on broker");
  EXPECT_EQ(present_[2].fault, "is there twice: the one on port 2 says that it is it");
  EXPECT_EQ(present_[0].fault, "");
  EXPECT_EQ(present_[3].fault, "");
  for (std::size_t outlet = 0; outlet < 4; ++outlet) {
    EXPECT_TRUE(link_->send(outlet, {}).ok());
  }
  EXPECT_THAT(sent_to_first_, ElementsAre(0));
  EXPECT_THAT(sent_to_second_, ElementsAre(1));
  std::vector<Received> messages;
  std::vector<Fault> faults;
  ASSERT_TRUE(link_->poll(messages, faults).ok());
  ASSERT_EQ(messages.size(), 2U);
  EXPECT_EQ(messages[0].outlet, 0U);
  EXPECT_EQ(messages[1].outlet, 3U);
  ASSERT_EQ(faults.size(), 2U);
  EXPECT_EQ(faults[1].what, "of c");
}

TEST_F(TwoLinks, HaveNoOutletWhereOneOfThemCannotBeOpened) {
  refused_ = true;
  open({outlet("a", "port 1")}, {});
  EXPECT_THAT(present_, IsEmpty());
  EXPECT_FALSE(link_->send(0, {}).ok());
  std::vector<Received> messages;
  std::vector<Fault> faults;
  EXPECT_TRUE(link_->poll(messages, faults).ok());
  EXPECT_THAT(faults, IsEmpty());
}

TEST_F(TwoLinks, PassOnWhatOneOfThemFoundAtFault) {
  open({{"a", "port 1", {}, "does not answer"}}, {});
  EXPECT_EQ(present_[0].fault, "does not answer");
  EXPECT_THAT(sent_to_first_, IsEmpty());
}

}  // namespace
