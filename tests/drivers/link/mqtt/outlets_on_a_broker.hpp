// A private broker with outlets a, b and c on its list, a link to it, and all that came over it.
#pragma once

#include "mqtt_outlet.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::test {

class OutletsOnABroker : public testing::Test {
 protected:
  void SetUp() override {
    auto started = broker::PrivateBroker::start({folder_.file("broker"), {"a", "b", "c"}});
    ASSERT_TRUE(started.ok()) << started.error();
    broker_ = std::make_unique<broker::PrivateBroker>(started.take());
  }

  link::MqttOptions options(std::vector<std::string> outlets) const {
    link::MqttOptions all;
    all.url = broker_->url();
    all.ca_file = broker_->ca_file();
    all.user = broker_->bench().user;
    all.password = broker_->bench().password;
    all.outlets = std::move(outlets);
    all.search = std::chrono::milliseconds(300);
    all.patience = std::chrono::milliseconds(1500);
    return all;
  }

  void open(std::vector<std::string> outlets) {
    link_ = std::make_unique<link::MqttLink>(options(std::move(outlets)));
    const auto opened = link_->open();
    ASSERT_TRUE(opened.ok()) << opened.error();
  }

  // The error of an opening that fails.
  static std::string refusal(const link::MqttOptions& wrong) {
    link::MqttLink link(wrong);
    const auto opened = link.open();
    return opened.ok() ? "it opened" : opened.error();
  }

  // Polls until it holds; false after ten seconds.
  bool until(const std::function<bool()>& condition) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(10);
    while (true) {
      EXPECT_TRUE(link_->poll(messages_, faults_).ok());
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

  TemporaryFolder folder_;
  std::unique_ptr<broker::PrivateBroker> broker_;
  std::unique_ptr<link::MqttLink> link_;
  std::vector<link::Received> messages_;
  std::vector<link::Fault> faults_;
};

}  // namespace gsbench::test
