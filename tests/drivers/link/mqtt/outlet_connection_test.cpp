// The outlet's end of MQTT: the addresses that it accepts, and why it cannot connect.
#include "certified_broker.hpp"
#include <mqtt_carrier.hpp>
#include <password_file.hpp>
#include <sys/socket.h>
#include <test_support/temporary_folder.hpp>
#include <test_support/waiting.hpp>

#include <cstdlib>
#include <optional>
#include <vector>

#include <gmock/gmock.h>

#include <transport/transport.hpp>
#include <wire/messages.hpp>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::HasSubstr;
using testing::StartsWith;

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

TEST(OutletConnection, StatesWhyACertificateIsRefusedAsTheBenchDoes) {
  const std::string refused = "has a certificate that is refused: ";
  const CertifiedBroker broker{Certificate()};
  const CertifiedBroker other{Certificate()};
  EXPECT_THAT(trouble_of_outlet(broker.url(), other.ca_file()),
              AllOf(StartsWith(refused), HasSubstr("; the CA file is \"" + other.ca_file() + '"')));
  const CertifiedBroker expired({"IP:127.0.0.1", -1});
  EXPECT_EQ(trouble_of_outlet(expired.url(), expired.ca_file()),
            refused + "certificate has expired");
  const CertifiedBroker elsewhere({"DNS:broker.example"});
  EXPECT_EQ(trouble_of_outlet(elsewhere.url(), elsewhere.ca_file()),
            refused + "IP address mismatch");
  EXPECT_EQ(trouble_of_outlet("mqtts://localhost:" + elsewhere.port(), elsewhere.ca_file()),
            refused + "hostname mismatch");
}

TEST(OutletConnection, StatesWhyThereIsNone) {
  const CertifiedBroker plain;
  const CertifiedBroker tls{Certificate()};
  EXPECT_EQ(trouble_of_outlet(plain.url("mqtt"), ""), "");
  EXPECT_THAT(trouble_of_outlet(plain.url(), tls.ca_file()),
              AllOf(StartsWith("fails the TLS handshake: "),
                    HasSubstr("there may be no TLS on this port")));
  EXPECT_EQ(trouble_of_outlet(tls.url("mqtt"), ""),
            "ended the connection without an answer; it may speak TLS on this port: mqtts://");
  EXPECT_THAT(trouble_of_outlet("mqtt://no-such-host.invalid:1883", ""),
              StartsWith("cannot be found: "));
  const auto free = emulation::LoopbackPort::reserve().take();
  EXPECT_EQ(trouble_of_outlet("mqtt://127.0.0.1:" + std::to_string(free.number()), ""),
            "cannot be connected to: Connection refused");
  const CertifiedBroker strict({"IP:127.0.0.1", 14, true});
  // Its alert is lost if the connection is reset before it is read.
  EXPECT_THAT(trouble_of_outlet(strict.url(), strict.ca_file()),
              AnyOf("ends the TLS connection: tlsv13 alert certificate required",
                    StartsWith("ended the TLS connection without an answer; it may require a "
                               "certificate of its clients")));
}

// As behind a firewall that drops packets.
TEST(OutletConnection, DoesNotBlockWithoutAnAnswerAndEndsTheAttempt) {
  auto port = emulation::LoopbackPort::reserve().take();
  ASSERT_TRUE(port.listen().ok());
  ASSERT_EQ(listen(port.descriptor(), 0), 0);
  const std::string address = "tcp://127.0.0.1:" + std::to_string(port.number());
  const auto filling = transport::make_transport(address);
  ASSERT_TRUE(filling->open().ok());
  gs::host::MqttCarrier carrier;
  std::string why;
  ASSERT_TRUE(carrier.start({"mqtt" + address.substr(3), "", "a", "", "a", 1}, why)) << why;
  int served = 0;
  EXPECT_TRUE(until([&] {
    carrier.serve();
    served += carrier.is_connecting() ? 1 : 0;
    return !carrier.trouble().empty();
  }));
  EXPECT_GT(served, 10);
  EXPECT_EQ(carrier.trouble(), "cannot be connected to: Connection timed out");
}

TEST(OutletConnection, KeepsNoHelloForTheNextConnection) {
  std::optional<CertifiedBroker> broker;
  broker.emplace();
  gs::host::MqttCarrier carrier;
  std::string why;
  ASSERT_TRUE(carrier.start({broker->url("mqtt"), "", "a", "", "a", 1}, why)) << why;
  const auto serve_until = [&](bool connected) {
    return until([&] {
      carrier.serve();
      return carrier.connected() == connected;
    });
  };
  ASSERT_TRUE(serve_until(true));
  broker.reset();
  ASSERT_TRUE(serve_until(false));
  EXPECT_THAT(carrier.trouble(), StartsWith("ended the connection: it has stopped, or another"));
  const auto send = [&](gs::wire::UplinkKind kind) {
    const std::uint8_t message[] = {0x81, static_cast<std::uint8_t>(kind)};
    return carrier.send(message, sizeof message);
  };
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(send(gs::wire::UplinkKind::kHello));
  }
  for (int i = 0; i < 1000; ++i) {
    ASSERT_TRUE(send(gs::wire::UplinkKind::kEvent)) << "there is room for this many";
  }
  EXPECT_FALSE(send(gs::wire::UplinkKind::kEvent));
  EXPECT_TRUE(send(gs::wire::UplinkKind::kHello));
}

TEST(OutletConnection, RefusesACaFileThatIsNone) {
  const CertifiedBroker broker{Certificate()};
  const TemporaryFolder folder;
  const auto expect = [&](const std::string& file, const std::string& why) {
    EXPECT_EQ(trouble_of_outlet(broker.url(), file),
              "the CA file \"" + file + "\" cannot be read (--ca): " + why);
  };
  expect("/nowhere/ca.pem", "No such file or directory");
  expect(folder.path().string(), "Is a directory");
  expect(folder.write("empty", ""), "it is empty");
  expect(folder.write("text", "no certificate\n"), "no certificate or crl found");
  EXPECT_EQ(trouble_of_outlet(broker.url(), ""),
            "mqtts:// needs --ca FILE, the CA certificate that signs the broker's certificate");
}

TEST(OutletConnection, StatesThatAnotherOutletTookItsPlace) {
  const CertifiedBroker broker;
  gs::host::MqttCarrier one;
  gs::host::MqttCarrier two;
  std::string why;
  ASSERT_TRUE(one.start({broker.url("mqtt"), "", "a", "", "a", 1}, why)) << why;
  ASSERT_TRUE(until([&] {
    one.serve();
    return one.connected();
  }));
  ASSERT_TRUE(two.start({broker.url("mqtt"), "", "a", "", "a", 1}, why)) << why;
  ASSERT_TRUE(until([&] {
    one.serve();
    two.serve();
    return !one.trouble().empty();
  }));
  EXPECT_THAT(one.trouble(), AllOf(StartsWith("ended the connection"),
                                   HasSubstr("another outlet with the same id and instance")));
}

// What it does not take waits at the broker, and nothing is lost.
TEST(OutletConnection, KeepsABoundedNumberOfMessagesThatTheOutletDoesNotTake) {
  constexpr int kSent = 900;  // the broker stores 1000
  const CertifiedBroker broker;
  gs::host::MqttCarrier slow;
  std::string why;
  ASSERT_TRUE(slow.start({broker.url("mqtt"), "", "a", "", "a", 1}, why)) << why;
  ASSERT_TRUE(until([&] {
    slow.serve();
    return slow.connected();
  }));
  slow.serve();  // sends its subscription
  for (int i = 0; i < kSent; ++i) {
    slow.serve();
  }
  const std::string publish = "for i in $(seq 1 " + std::to_string(kSent) +
                              "); do echo message $i; done | mosquitto_pub -h "
                              "127.0.0.1 -p " +
                              broker.port() + " -q 1 -t gs/a/down -l";
  ASSERT_EQ(std::system(publish.c_str()), 0);
  for (int i = 0; i < kSent; ++i) {
    slow.serve();
  }
  EXPECT_LE(slow.waiting(), 200U);
  int taken = 0;
  std::vector<std::uint8_t> message;
  EXPECT_TRUE(until([&] {
    slow.serve();
    while (slow.take(message)) {
      EXPECT_EQ(std::string(message.begin(), message.end()), "message " + std::to_string(++taken));
    }
    return taken == kSent;
  }));
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
  EXPECT_EQ(password_in(std::string(65535, 'x')).size(), 65535U);
  EXPECT_EQ(password_in(std::string(65536, 'x')),
            folder.file("pw") + ": its first line has 65536 bytes; a password has at most 65535");
  for (const std::string& content : {std::string(), std::string("\r\n"),
                                     std::string("\xEF\xBB\xBF"), std::string("s\0e\0", 4)}) {
    EXPECT_EQ(password_in(content),
              folder.file("pw") + ": its first line must be the password, as UTF-8 text");
  }
}

}  // namespace
}  // namespace gsbench::test
