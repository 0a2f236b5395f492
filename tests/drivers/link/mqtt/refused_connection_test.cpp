// Each reason why a broker cannot be connected to has a message of its own.
#include "certified_broker.hpp"
#include <link_mqtt/mqtt_link.hpp>
#include <link_test/link_fixture.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using link::MqttLink;
using link::MqttOptions;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

std::string refusal(const std::string& url, const std::string& ca_file = "") {
  MqttOptions options;
  options.url = url;
  options.ca_file = ca_file;
  MqttLink link(options);
  const drivers::Status opened = link.open();
  return opened.ok() ? "" : opened.error();
}

std::string certificate_refused(const std::string& url, const std::string& why) {
  return "the broker " + url + " has a certificate that is refused: " + why;
}

TEST(RefusedConnection, BrokerWithAGoodCertificateIsConnectedTo) {
  const CertifiedBroker broker{Certificate()};
  EXPECT_EQ(refusal(broker.url(), broker.ca_file()), "");
  EXPECT_EQ(refusal(broker.url("MQTTS") + '/', broker.ca_file()), "");
}

TEST(RefusedConnection, BrokerAtAnIpv6AddressIsConnectedToAndItsCertificateChecked) {
  const CertifiedBroker broker({"IP:::1"}, "[::1]");
  EXPECT_EQ(refusal(broker.url(), broker.ca_file()), "");
  const CertifiedBroker other({"IP:::2"}, "[::1]");
  EXPECT_EQ(refusal(other.url(), other.ca_file()),
            certificate_refused(other.url(), "IP address mismatch"));
}

TEST(RefusedConnection, CertificateOfAnotherCaIsRefused) {
  const CertifiedBroker broker{Certificate()};
  const CertifiedBroker other{Certificate()};
  EXPECT_THAT(refusal(broker.url(), other.ca_file()),
              StartsWith(certificate_refused(broker.url(), "")));
  EXPECT_THAT(refusal(broker.url(), other.ca_file()),
              HasSubstr("; the CA file is \"" + other.ca_file() + "\""));
}

TEST(RefusedConnection, ExpiredCertificateIsRefused) {
  const CertifiedBroker broker({"IP:127.0.0.1", -1});
  EXPECT_EQ(refusal(broker.url(), broker.ca_file()),
            certificate_refused(broker.url(), "certificate has expired"));
}

TEST(RefusedConnection, CertificateOfAnotherHostIsRefused) {
  const CertifiedBroker broker({"DNS:broker.example"});
  EXPECT_EQ(refusal(broker.url(), broker.ca_file()),
            certificate_refused(broker.url(), "IP address mismatch"));
  const std::string by_name = "mqtts://localhost:" + broker.port();
  EXPECT_EQ(refusal(by_name, broker.ca_file()), certificate_refused(by_name, "hostname mismatch"));
}

TEST(RefusedConnection, BrokerThatRequiresACertificateSaysSo) {
  const CertifiedBroker broker({"IP:127.0.0.1", 14, true});
  EXPECT_THAT(refusal(broker.url(), broker.ca_file()),
              AllOf(StartsWith("the broker " + broker.url() + " ends the TLS connection: "),
                    HasSubstr("certificate required")));
}

TEST(RefusedConnection, PortWithoutTlsAndPortWithTlsAreDistinguished) {
  const CertifiedBroker plain;
  const CertifiedBroker tls{Certificate()};
  EXPECT_EQ(refusal(plain.url("mqtt")), "");
  EXPECT_THAT(refusal(plain.url(), tls.ca_file()),
              AllOf(StartsWith("the broker " + plain.url() + " fails the TLS handshake: "),
                    HasSubstr("there may be no TLS on this port")));
  EXPECT_EQ(refusal(tls.url("mqtt")),
            "the broker " + tls.url("mqtt") +
                " speaks TLS on this port; its address begins with mqtts://");
}

TEST(RefusedConnection, PortWithoutAListenerAndUnknownHostAreNamed) {
  const auto free = emulation::LoopbackPort::reserve().take();
  for (const std::string scheme : {"mqtt", "mqtts"}) {
    const std::string closed = scheme + "://127.0.0.1:" + std::to_string(free.number());
    EXPECT_EQ(refusal(closed),
              "the broker " + closed + " cannot be connected to: Connection refused");
    const std::string nowhere = scheme + "://no-such-host.invalid:8883";
    EXPECT_THAT(refusal(nowhere), StartsWith("the broker " + nowhere + " cannot be found: "));
  }
}

}  // namespace
}  // namespace gsbench::test
