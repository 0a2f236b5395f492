// Somebody with Mosquitto's own command-line clients and whatever credentials are in hand.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>
#include <vector>

#include <emulation/private_broker.hpp>

namespace gsbench::test {

struct Outsider {
  const emulation::PrivateBroker& target;
  std::string ca_file;
  emulation::Login login;

  // What the topic's retained message is, for who may read it; "" for who may not.
  std::string read(const std::string& topic) const {
    return run("mosquitto_sub" + identity() + " -t '" + topic + "' -C 1 -W 1");
  }

  // Left there as a retained message, so that it can be read afterwards.
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
    std::string text;
    std::FILE* const pipe = popen((command + " 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) {
      return "popen failed";
    }
    std::array<char, 256> buffer{};
    while (std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe) != nullptr) {
      text += buffer.data();
    }
    pclose(pipe);
    return text.substr(0, text.find('\n'));
  }
};

}  // namespace gsbench::test
