// A client of the private broker with arbitrary credentials: Mosquitto's command-line clients.
#pragma once

#include <test_support/output_of.hpp>

#include <string>

#include <emulation/private_broker.hpp>

namespace gsbench::test {

struct BrokerClient {
  const emulation::PrivateBroker& target;
  std::string ca_file;
  emulation::Login login;

  // The topic's retained message; "" if there is none or reading is refused.
  std::string read(const std::string& topic) const {
    return run("mosquitto_sub" + identity() + " -t '" + topic + "' -C 1 -W 1");
  }

  // Publishes a retained message, so that it can be read afterwards.
  void write(const std::string& topic, const std::string& text) const {
    run("mosquitto_pub" + identity() + " -t '" + topic + "' -r -q 1 -m '" + text + "'");
  }

 private:
  std::string identity() const {
    std::string words = " -h 127.0.0.1 -V mqttv5 -p " + std::to_string(target.port());
    if (!ca_file.empty()) {
      words += " --cafile '" + ca_file + "'";
    }
    if (!login.user.empty()) {
      words += " -u '" + login.user + "' -P '" + login.password + "'";
    }
    return words;
  }

  static std::string run(const std::string& command) {
    const std::string text = output_of(command + " 2>/dev/null").text;
    return text.substr(0, text.find('\n'));
  }
};

}  // namespace gsbench::test
