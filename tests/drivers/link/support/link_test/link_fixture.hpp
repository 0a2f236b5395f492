// A test fixture with a link; collects joined outlets, messages and faults.
#pragma once

#include <test_support/waiting.hpp>
#include <wire_test/downlinks.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <link/wait_for_outlets.hpp>

namespace gsbench::test {

// Ids of the outlets that most tests have.
constexpr const char* kA = "a";
constexpr const char* kB = "b";

using gs::wire::test::command;
using gs::wire::test::downlink;
using gs::wire::test::ping;

class LinkFixture : public testing::Test {
 protected:
  // The link is destroyed before its outlets.
  void TearDown() override { link_.reset(); }

  void open(std::shared_ptr<link::Link> link, const std::vector<std::string>& named = {kA, kB},
            std::chrono::milliseconds patience = std::chrono::milliseconds(1500),
            std::chrono::milliseconds others_for = {}) {
    link_ = std::move(link);
    auto opened = link::wait_for_outlets(*link_, named, patience, others_for);
    ASSERT_TRUE(opened.ok()) << opened.error();
    present_ = opened.take();
  }

  // The error of an open() that fails.
  static std::string refusal(link::Link&& link) {
    const auto opened = link.open();
    return opened.ok() ? "it opened" : opened.error();
  }

  // The outlet found by open() for this id or place.
  const link::OutletPresence& present(const std::string& name) const {
    const auto found = std::find_if(present_.begin(), present_.end(), [&](const auto& outlet) {
      return outlet.id == name || outlet.where == name;
    });
    if (found == present_.end()) {
      throw std::runtime_error("no outlet " + name);
    }
    return *found;
  }

  void send(const std::string& id, const gs::wire::Downlink& message) {
    const auto sent = link_->send(id, message);
    ASSERT_TRUE(sent.ok()) << sent.error();
  }

  void poll() {
    link::Happenings happenings;
    const auto polled = link_->poll(happenings);
    ASSERT_TRUE(polled.ok()) << polled.error();
    for (const link::Change& change : happenings.changes) {
      if (const auto* const joined = std::get_if<link::OutletPresence>(&change)) {
        joined_.push_back(*joined);
      } else {
        faults_.push_back(std::get<link::Fault>(change));
      }
    }
    changes_.insert(changes_.end(), happenings.changes.begin(), happenings.changes.end());
    messages_.insert(messages_.end(), happenings.messages.begin(), happenings.messages.end());
    faults_.insert(faults_.end(), happenings.faults.begin(), happenings.faults.end());
  }

  // Polls until the condition holds; false after 1 min.
  bool until(const std::function<bool()>& condition) {
    return test::until([&] {
      poll();
      return condition();
    });
  }

  bool arrives(const std::string& id, gs::wire::UplinkKind kind, std::size_t count = 1) {
    return until([&] { return messages(id, kind).size() >= count; });
  }

  bool answers(const std::string& id, std::uint32_t token = 1) {
    send(id, ping(token));
    return until([&] {
      const auto echoes = messages(id, gs::wire::UplinkKind::kEcho);
      return std::any_of(echoes.begin(), echoes.end(), [&](const link::Received& received) {
        return received.message.echo.token == token;
      });
    });
  }

  std::vector<link::Received> messages(const std::string& id, gs::wire::UplinkKind kind) const {
    std::vector<link::Received> found;
    std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
                 [&](const link::Received& received) {
                   return received.id == id && received.message.kind == kind;
                 });
    return found;
  }

  std::vector<std::string> faults(const std::string& id) const {
    std::vector<std::string> what;
    for (const link::Fault& fault : faults_) {
      if (fault.id == id) {
        what.push_back(fault.what);
      }
    }
    return what;
  }

  bool reported(const std::string& id, const std::string& words) const {
    const auto all = faults(id);
    return std::any_of(all.begin(), all.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }

  bool is_reported(const std::string& id, const std::string& words) {
    return until([&] { return reported(id, words); });
  }

  std::shared_ptr<link::Link> link_;
  std::vector<link::OutletPresence> present_;
  std::vector<link::Received> messages_;
  std::vector<link::Change> changes_;         // after open()
  std::vector<link::OutletPresence> joined_;  // of these
  std::vector<link::Fault> faults_;           // including those of outlets that left
};

}  // namespace gsbench::test
