// Paho as it is linked here (drivers/link/mqtt/paho): it reads ahead and still misses nothing, and
// keeps no records of its memory.
#include "tls_peer.hpp"
#include <mqtt/async_client.h>
#include <test_support/temporary_folder.hpp>

#include <chrono>
#include <cstddef>
#include <future>
#include <string>

#include <gtest/gtest.h>

#include <emulation/private_broker.hpp>

// Of Paho's Heap.h, which is not installed.
extern "C" {
struct HeapInfo {
  std::size_t current_size;
  std::size_t max_size;
};
HeapInfo* Heap_get_info(void);
}

namespace {

using gsbench::emulation::Login;
using gsbench::emulation::PrivateBroker;
using gsbench::test::publish_packet;
using gsbench::test::TemporaryFolder;
using gsbench::test::TlsPeer;

constexpr int kBurst = 500;
constexpr auto kPatience = std::chrono::seconds(10);
// Nothing comes from the broker but what a test sends: no answers to a client that asks whether it
// is still there.
constexpr auto kKeepAlive = std::chrono::seconds(60);

class PahoAsItIsLinked : public testing::Test {
 protected:
  PahoAsItIsLinked() {
    connect(outlet_, broker_.outlet("a"));
    connect(bench_, broker_.bench());
    bench_.start_consuming();
    bench_.subscribe("gs/a/up", 0)->wait();
  }

  static PrivateBroker start(const std::string& folder) {
    auto started = PrivateBroker::start({folder, {"a"}});
    EXPECT_TRUE(started.ok()) << started.error();
    return started.take();
  }

  void connect(mqtt::async_client& client, const Login& login) const {
    mqtt::connect_options options(login.user, login.password);
    options.set_keep_alive_interval(kKeepAlive);
    mqtt::ssl_options tls;
    tls.set_trust_store(broker_.ca_file());
    options.set_ssl(tls);
    client.connect(options)->wait();
  }

  std::string url() const { return "ssl://127.0.0.1:" + std::to_string(broker_.port()); }

  void say(const std::string& text) {
    outlet_.publish("gs/a/up", text.data(), text.size(), 0, false)->wait();
  }

  std::string hear() {
    mqtt::const_message_ptr message;
    return bench_.try_consume_message_for(&message, kPatience) ? message->to_string() : "nothing";
  }

  TemporaryFolder folder_;
  PrivateBroker broker_ = start(folder_.file("broker"));
  mqtt::async_client outlet_{url(), "outlet", mqtt::create_options(MQTTVERSION_DEFAULT, kBurst)};
  mqtt::async_client bench_{url(), "bench"};
};

// One of TLS's records holds 16 KiB, as does what is read ahead: often, that is a record's end and
// the whole of the next and last.
TEST_F(PahoAsItIsLinked, WhatSpansRecordsArrivesWithNothingToFollow) {
  for (int i = 0; i < 500; ++i) {
    const std::size_t size = i % 10 == 0 ? 100000 : 16400;
    const std::string text(size, static_cast<char>('a' + i % 26));
    say(text);
    ASSERT_EQ(hear(), text) << "message " << i;
  }
}

TEST_F(PahoAsItIsLinked, ManyRecordsThatComeTogetherArriveWithNothingToFollow) {
  for (int round = 0; round < 20; ++round) {
    for (int i = 0; i < kBurst; ++i) {
      outlet_.publish("gs/a/up", std::to_string(i), 0, false);
    }
    for (int i = 0; i < kBurst; ++i) {
      ASSERT_EQ(hear(), std::to_string(i)) << "in round " << round;
    }
  }
}

TEST_F(PahoAsItIsLinked, KeepsNoRecordsOfItsMemory) {
  say("something");
  ASSERT_EQ(hear(), "something");
  EXPECT_EQ(Heap_get_info()->max_size, 0U);
}

// What Mosquitto does not do on demand.
class PahoAndItsPeer : public testing::Test {
 protected:
  PahoAndItsPeer() {
    mqtt::ssl_options tls;
    tls.set_enable_server_cert_auth(false);
    mqtt::connect_options options;
    options.set_mqtt_version(MQTTVERSION_3_1_1);
    options.set_keep_alive_interval(kKeepAlive);
    options.set_ssl(tls);
    bench_.start_consuming();
    bench_.set_connection_lost_handler([this](const std::string&) { lost_.set_value(); });
    bench_.connect(options)->wait();
  }

  TlsPeer peer_;
  std::promise<void> lost_;
  mqtt::async_client bench_{"ssl://127.0.0.1:" + std::to_string(peer_.port()), "bench"};
};

TEST_F(PahoAndItsPeer, WhatFollowsAPacketWithoutABodyIsNotOverlooked) {
  const std::string answer_to_ping("\xD0\x00", 2);
  peer_.send_together({answer_to_ping, publish_packet("topic", "after it")});
  mqtt::const_message_ptr message;
  ASSERT_TRUE(bench_.try_consume_message_for(&message, kPatience));
  EXPECT_EQ(message->to_string(), "after it");
}

TEST_F(PahoAndItsPeer, AnErrorBehindHalfAPacketIsToldAtOnce) {
  const std::string packet = publish_packet("topic", "never whole");
  peer_.send_damaged({packet.substr(0, 10), packet.substr(10)});
  EXPECT_EQ(lost_.get_future().wait_for(kPatience), std::future_status::ready);
}

}  // namespace
