// The outlet's end of MQTT: the addresses that it accepts, and why it cannot connect.
#include "certified_broker.hpp"
#include <mqtt_carrier.hpp>
#include <test_support/waiting.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::HasSubstr;

// "" once it is connected, otherwise why it is not.
std::string trouble_of_outlet(const std::string& url, const std::string& ca_file) {
  gs::host::MqttCarrier carrier;
  std::string why;
  if (!carrier.start({url, ca_file, "a", "", "a", 1}, why)) {
    return why;
  }
  EXPECT_TRUE(until([&] {
    carrier.serve();
    return carrier.connected() || !carrier.trouble().empty();
  }));
  return carrier.connected() ? "" : carrier.trouble();
}

TEST(OutletConnection, AcceptsTheFormsOfAnAddressThatTheBenchAccepts) {
  const CertifiedBroker broker{Certificate()};
  EXPECT_EQ(trouble_of_outlet(broker.url("MQTTS") + '/', broker.ca_file()), "");
  const CertifiedBroker ipv6({"IP:::1"}, "[::1]");
  EXPECT_EQ(trouble_of_outlet(ipv6.url(), ipv6.ca_file()), "");
  for (const std::string wrong : {"mqtts://::1:8883", "mqtts://b:8883//", "mqtts://b", "tcp://b:1",
                                  "mqtts://user@b:8883", "mqtts://b:0", "mqtts://b:8883x"}) {
    EXPECT_THAT(trouble_of_outlet(wrong, broker.ca_file()), HasSubstr("is not mqtts://host:port"));
  }
}

TEST(OutletConnection, StatesWhyTlsFails) {
  const CertifiedBroker broker{Certificate()};
  const CertifiedBroker other{Certificate()};
  EXPECT_THAT(trouble_of_outlet(broker.url(), other.ca_file()),
              HasSubstr("certificate verify failed"));
  const CertifiedBroker elsewhere({"DNS:broker.example"});
  EXPECT_THAT(trouble_of_outlet(elsewhere.url(), elsewhere.ca_file()), HasSubstr("host name"));
  EXPECT_EQ(trouble_of_outlet(broker.url(), "/nowhere/ca.pem"),
            "the CA file \"/nowhere/ca.pem\" cannot be read (--ca): No such file or directory");
}

TEST(OutletConnection, PasswordFilesOfOtherEditorsAreRead) {
  const TemporaryFolder folder;
  const auto password_in = [&](const std::string& content) {
    std::string password;
    std::string why;
    return gs::host::read_password(folder.write("pw", content), password, why) ? password : why;
  };
  for (const char* content : {"secret", "secret\n", "secret\r\nmore", "\xEF\xBB\xBFsecret\r\n"}) {
    EXPECT_EQ(password_in(content), "secret");
  }
  EXPECT_EQ(password_in(" two words \n"), " two words ");
  for (const std::string& content : {std::string(), std::string("\r\n"),
                                     std::string("\xEF\xBB\xBF"), std::string("s\0e\0", 4)}) {
    EXPECT_EQ(password_in(content),
              folder.file("pw") + ": its first line must be the password, as UTF-8 text");
  }
}

}  // namespace
}  // namespace gsbench::test
