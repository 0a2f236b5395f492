// What comes over a link in a test, kept until it is asked for.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <link/link.hpp>

namespace gsbench::test {

class HearsALink : public testing::Test {
 protected:
  // The link goes before what it leads to.
  void TearDown() override { link_.reset(); }

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

  std::vector<link::Received> messages(std::size_t outlet, gs::wire::UplinkKind kind) const {
    std::vector<link::Received> found;
    std::copy_if(messages_.begin(), messages_.end(), std::back_inserter(found),
                 [&](const link::Received& received) {
                   return received.outlet == outlet && received.message.kind == kind;
                 });
    return found;
  }

  std::vector<std::string> faults(std::size_t outlet) const {
    std::vector<std::string> told;
    for (const link::Fault& fault : faults_) {
      if (fault.outlet == outlet) {
        told.push_back(fault.what);
      }
    }
    return told;
  }

  bool told(std::size_t outlet, const std::string& words) const {
    const auto all = faults(outlet);
    return std::any_of(all.begin(), all.end(), [&](const std::string& fault) {
      return fault.find(words) != std::string::npos;
    });
  }

  std::unique_ptr<link::Link> link_;
  std::vector<link::Received> messages_;
  std::vector<link::Fault> faults_;
};

}  // namespace gsbench::test
