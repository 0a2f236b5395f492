// Why a broker cannot be connected to. Paho reports one error for all causes, and its handler of
// TLS errors does not get the failed check of a certificate.
#pragma once

#include <link_mqtt/broker_url.hpp>

#include <string>

namespace gsbench::link {

// Tries the steps of a connection: look-up of the host, TCP, and TLS with the checks that
// BrokerConnection asks of Paho. Returns what the first failed step reports (resolver, kernel or
// OpenSSL) as the end of a sentence, "cannot be found: …"; empty if all succeed. Sends no MQTT.
// Blocks for 0.5 s for each address and 5 s for TLS at most, plus the look-up.
std::string trouble_with(const BrokerUrl& broker, const std::string& ca_file);

}  // namespace gsbench::link
