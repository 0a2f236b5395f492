// A private broker with outlets a, b and c on its list, a link to it, and all that came over it.
#pragma once

#include "mqtt_outlet.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <link_test/hears_a_link.hpp>
#include <test_support/temporary_folder.hpp>

#include <chrono>
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
    all.search = std::chrono::milliseconds(300);
    all.patience = std::chrono::milliseconds(1500);
    return all;
  }

  void open(std::vector<std::string> outlets) {
    link_ = std::make_unique<link::MqttLink>(options(std::move(outlets)));
    auto opened = link_->open();
    ASSERT_TRUE(opened.ok()) << opened.error();
    present_ = opened.take();
  }

  bool answers(std::size_t outlet) {
    gs::wire::Downlink ping;
    ping.kind = gs::wire::DownlinkKind::kPing;
    return link_->send(outlet, ping).ok() &&
           until([&] { return !messages(outlet, gs::wire::UplinkKind::kEcho).empty(); });
  }

  // The error of an opening that fails.
  static std::string refusal(const link::MqttOptions& wrong) {
    link::MqttLink link(wrong);
    const auto opened = link.open();
    return opened.ok() ? "it opened" : opened.error();
  }

  TemporaryFolder folder_;
  std::unique_ptr<emulation::PrivateBroker> broker_;
  std::vector<link::OutletPresence> present_;
};

}  // namespace gsbench::test
