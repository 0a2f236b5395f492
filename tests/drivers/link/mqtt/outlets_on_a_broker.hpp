// A private broker with logins for outlets a, b and c, and a link to it.
#pragma once

#include "mqtt_outlet.hpp"
#include <link_test/bench_options.hpp>
#include <link_test/link_fixture.hpp>
#include <test_support/demand.hpp>
#include <test_support/temporary_folder.hpp>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::test {

class OutletsOnABroker : public LinkFixture {
 protected:
  link::MqttOptions options(const std::vector<std::string>& outlets) const {
    return bench_options(broker_, outlets);
  }

  void open(const std::vector<std::string>& outlets) {
    LinkFixture::open(std::make_shared<link::MqttLink>(options(outlets)), outlets);
  }

  // An outlet with the id kA joins without a fault, and answers.
  void expect_joins(std::uint32_t instance) {
    ASSERT_TRUE(until([&] { return !joined_.empty(); }));
    EXPECT_EQ(joined_.back().hello.instance, instance);
    EXPECT_EQ(joined_.back().fault, "");
    EXPECT_TRUE(answers(kA));
  }

  static std::string refusal(const link::MqttOptions& wrong) {
    return LinkFixture::refusal(link::MqttLink(wrong));
  }

  TemporaryFolder folder_;
  emulation::PrivateBroker broker_ =
      demand(emulation::PrivateBroker::start({folder_.file("broker"), {"a", "b", "c"}}));
};

}  // namespace gsbench::test
