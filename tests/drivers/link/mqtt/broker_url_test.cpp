// The forms of a broker's address, which bench and outlets read alike.
#include <address.hpp>
#include <link_mqtt/broker_url.hpp>

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

std::string in_one_form(const std::string& text) {
  const auto url = link::read_broker_url(text);
  gs::host::Address outlets;
  const bool is_broker = gs::host::read_address(text, outlets) &&
                         (outlets.scheme == "mqtt" || outlets.scheme == "mqtts");
  EXPECT_EQ(is_broker, url.has_value()) << text;
  if (url && is_broker) {
    EXPECT_EQ(outlets.scheme == "mqtts", url->tls) << text;
    EXPECT_EQ(outlets.host, url->host) << text;
    EXPECT_EQ(outlets.port, url->port) << text;
  }
  return url ? link::text_of(*url) : "refused";
}

TEST(BrokerUrl, SchemeMayBeInUpperCaseAndASlashMayFollow) {
  for (const char* text :
       {"mqtts://b:8883", "mqtts://b:8883/", "MQTTS://b:8883", "MqttS://b:08883/"}) {
    EXPECT_EQ(in_one_form(text), "mqtts://b:8883") << text;
  }
  EXPECT_EQ(in_one_form("MQTT://10.0.0.1:65535/"), "mqtt://10.0.0.1:65535");
}

TEST(BrokerUrl, Ipv6AddressIsInBrackets) {
  const auto url = link::read_broker_url("mqtts://[fe80::1%eth0]:8883/");
  ASSERT_TRUE(url);
  EXPECT_TRUE(url->tls);
  EXPECT_EQ(url->host, "fe80::1%eth0");
  EXPECT_EQ(url->port, 8883);
  EXPECT_EQ(link::text_of(*url), "mqtts://[fe80::1%eth0]:8883");
  for (const char* text : {"mqtt://::1:1883", "mqtt://[::1]", "mqtt://[::1:1883", "mqtt://[]:1883",
                           "mqtt://[127.0.0.1]:1883", "mqtt://[b]:1883", "mqtt://[::1]x:1883"}) {
    EXPECT_EQ(in_one_form(text), "refused") << text;
  }
}

TEST(BrokerUrl, OtherFormsAreRefused) {
  for (const char* text : {"",
                           "mqtt",
                           "mqtts",
                           "mqtt://",
                           "mqtt:/b:1",
                           "tcp://b:1",
                           "b:1883",
                           "mqtt://b",
                           "mqtt://b:",
                           "mqtt://:1883",
                           "mqtt://b:0",
                           "mqtt://b:65536",
                           "mqtt://b:-1",
                           "mqtt://b:+1",
                           "mqtt://b:1 ",
                           "mqtt://b:1883//",
                           "mqtt://b/c:1883",
                           "mqtt://user@b:1883",
                           "mqtt://user:secret@b:1883",
                           "mqtt://a b:1"}) {
    EXPECT_EQ(in_one_form(text), "refused") << text;
  }
  EXPECT_EQ(in_one_form("mqtt://" + std::string(254, 'b') + ":1"), "refused");
  EXPECT_NE(in_one_form("mqtt://" + std::string(253, 'b') + ":1"), "refused");
}

}  // namespace
}  // namespace gsbench::test
