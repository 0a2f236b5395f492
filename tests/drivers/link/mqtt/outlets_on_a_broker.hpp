// A private broker with outlets a, b and c on its list, a link to it, and all that came over it.
#pragma once

#include "mqtt_outlet.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <link_test/hears_a_link.hpp>
#include <test_support/temporary_folder.hpp>

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gsbench::test {

class OutletsOnABroker : public HearsALink {
 protected:
  void SetUp() override {
    auto started = emulation::PrivateBroker::start({folder_.file("broker"), {"a", "b", "c"}});
    ASSERT_TRUE(started.ok()) << started.error();
    broker_ = std::make_unique<emulation::PrivateBroker>(started.take());
  }

  link::MqttOptions options(std::vector<std::string> outlets) const {
    link::MqttOptions all;
    all.url = broker_->url();
    all.ca_file = broker_->ca_file();
    all.user = broker_->bench().user;
    all.password = broker_->bench().password;
    all.outlets = std::move(outlets);
    return all;
  }

  void open(const std::vector<std::string>& outlets) {
    HearsALink::open(std::make_shared<link::MqttLink>(options(outlets)), outlets);
  }

  static std::string refusal(const link::MqttOptions& wrong) {
    return HearsALink::refusal(link::MqttLink(wrong));
  }

  TemporaryFolder folder_;
  std::unique_ptr<emulation::PrivateBroker> broker_;
};

}  // namespace gsbench::test
