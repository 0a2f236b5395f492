// The outlet's end of a link over a carrier of whole messages, with a session that has begun.
#pragma once

#include <firmware_test/settings.hpp>
#include <wire_test/downlinks.hpp>
#include <wire_test/messages.hpp>

#include <vector>

#include <gtest/gtest.h>

#include <app/endpoint.hpp>

namespace gs::app {

using wire::DownlinkKind;
using wire::ErrorCode;
using wire::Uplink;
using wire::UplinkKind;
using wire::test::Bytes;
using wire::test::downlink;
using wire::test::encoded;
using wire::test::framed;
using wire::test::ping;

// A carrier of whole messages, which decodes them like the other side.
class Listener final : public Carrier {
 public:
  bool send(const std::uint8_t* bytes, std::size_t size) override {
    if (refuses) {
      return false;
    }
    Uplink message;
    std::uint32_t sequence = 0;
    EXPECT_EQ(wire::decode(bytes, size, message, sequence), wire::Decoded::kOk);
    received.push_back(message);
    numbers.push_back(sequence);
    return true;
  }
  const Uplink& last() const { return received.back(); }

  bool refuses = false;
  std::vector<Uplink> received;
  std::vector<std::uint32_t> numbers;
};

class FakeStorage final : public SettingsStorage {
 public:
  bool keep(const outlet::Settings& settings) override {
    if (!keeps) {
      return false;
    }
    kept.push_back(settings);
    return true;
  }
  bool usable() const override { return works; }

  bool keeps = true;
  bool works = true;
  std::vector<outlet::Settings> kept;
};

inline wire::Downlink settings_message(std::uint32_t version) {
  outlet::Settings settings = test::ieee24_settings();
  settings.version = version;
  return wire::test::settings_message(settings);
}

class EndpointTest : public testing::Test {
 protected:
  // Begins the session, whose next number is 0. The hello that was sent unasked stays.
  void SetUp() override {
    start(&storage_);
    send(downlink(DownlinkKind::kIdentify), 0xFFFFFFFFU);
    ASSERT_EQ(listener_.received.size(), 2U);
    listener_.received.pop_back();
    listener_.numbers.pop_back();
  }
  void start(SettingsStorage* storage) {
    ASSERT_TRUE(app_.start(outlet::Hardware{}, identity_, storage, endpoint_));
  }
  void send(const wire::Downlink& downlink, std::uint32_t sequence) {
    send(encoded(downlink, sequence));
  }
  void send(const Bytes& bytes) { endpoint_.receive(bytes.data(), bytes.size()); }
  void feed(std::size_t samples) {
    const std::vector<std::int16_t> silence(samples);
    app_.feed(silence.data(), silence.size(), endpoint_);
  }
  wire::Status status(std::uint32_t sequence) {
    send(downlink(DownlinkKind::kAskStatus), sequence);
    EXPECT_EQ(listener_.last().kind, UplinkKind::kStatus);
    return listener_.last().status;
  }

  static Identity test_identity() {
    Identity identity;
    set_text(identity.id, "outlet-7");
    return identity;
  }

  Identity identity_ = test_identity();
  Application app_;
  FakeStorage storage_;
  Listener listener_;
  MessageEndpoint endpoint_{app_, listener_};
};

}  // namespace gs::app
