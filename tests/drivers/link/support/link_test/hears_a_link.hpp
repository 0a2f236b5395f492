// A link in a test, and what came over it, kept until it is asked for.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <link/link.hpp>

namespace gsbench::test {

inline gs::wire::Downlink downlink(gs::wire::DownlinkKind kind) {
  gs::wire::Downlink message;
  message.kind = kind;
  return message;
}

inline gs::wire::Downlink ping(std::uint32_t token) {
  gs::wire::Downlink message = downlink(gs::wire::DownlinkKind::kPing);
  message.token = token;
  return message;
}

inline gs::wire::Downlink command(bool close, std::uint32_t request = 0) {
  gs::wire::Downlink message = downlink(gs::wire::DownlinkKind::kCommand);
  message.close_relay = close;
  message.request = request;
  return message;
}

class HearsALink : public testing::Test {
 protected:
  // The link goes before what it leads to.
  void TearDown() override { link_.reset(); }

  void open(std::shared_ptr<link::Link> link) {
    link_ = std::move(link);
    auto opened = link_->open();
    ASSERT_TRUE(opened.ok()) << opened.error();
    present_ = opened.take();
  }

  // The error of an opening that fails.
  static std::string refusal(link::Link&& link) {
    const auto opened = link.open();
    return opened.ok() ? "it opened" : opened.error();
  }

  void send(std::size_t outlet, const gs::wire::Downlink& message) {
    const auto sent = link_->send(outlet, message);
    ASSERT_TRUE(sent.ok()) << sent.error();
  }

  void poll() {
    const auto polled = link_->poll(messages_, faults_);
    ASSERT_TRUE(polled.ok()) << polled.error();
  }

  // Polls until it holds; false after ten seconds.
  bool until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (true) {
      poll();
      if (condition()) {
        return true;
      }
      if (std::chrono::steady_clock::now() > end) {
        return false;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }

  bool comes(std::size_t outlet, gs::wire::UplinkKind kind, std::size_t count = 1) {
    return until([&] { return messages(outlet, kind).size() >= count; });
  }

  bool answers(std::size_t outlet, std::uint32_t token = 1) {
    send(outlet, ping(token));
    return until([&] {
      const auto echoes = messages(outlet, gs::wire::UplinkKind::kEcho);
      return std::any_of(echoes.begin(), echoes.end(), [&](const link::Received& received) {
        return received.message.echo.token == token;
      });
    });
  }

  std::vector<link::Received> messages(std::size_t outlet, gs::wire::UplinkKind kind) const {
    std::vector<link::Received> found;
    std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
                 [&](const link::Received& received) {
                   return received.outlet == outlet && received.message.kind == kind;
                 });
    return found;
  }

  std::vector<std::string> faults(std::size_t outlet) const {
    std::vector<std::string> what;
    for (const link::Fault& fault : faults_) {
      if (fault.outlet == outlet) {
        what.push_back(fault.what);
      }
    }
    return what;
  }

  bool reported(std::size_t outlet, const std::string& words) const {
    const auto all = faults(outlet);
    return std::any_of(all.begin(), all.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }

  bool is_reported(std::size_t outlet, const std::string& words) {
    return until([&] { return reported(outlet, words); });
  }

  std::shared_ptr<link::Link> link_;
  std::vector<link::OutletPresence> present_;
  std::vector<link::Received> messages_;
  std::vector<link::Fault> faults_;
};

}  // namespace gsbench::test
