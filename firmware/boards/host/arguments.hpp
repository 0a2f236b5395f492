// The command line of gs-outlet.
#pragma once

#include "mqtt_carrier.hpp"

#include <cstdint>
#include <string>

namespace gs::host {

extern const char* const kHelp;

struct Arguments {
  // One of these. For MQTT, mqtt.url.
  std::string tcp;
  std::string listen;
  std::string serial;
  MqttOptions mqtt;
  std::string password_file;

  // With the bench.
  std::string terminals;
  std::string doorbell;

  // Without it.
  std::string id;
  std::uint32_t instance = 1;
  std::int32_t nominal_hz = 50;
  std::int32_t sample_rate_hz = 8000;
  std::string signal;
  double loss_mw = 0.0;
  double loss_at_s = 10.0;
  std::string flash;

  bool alone() const { return terminals.empty(); }
};

// Returns false with the reason in `why`.
bool parse(int argc, char** argv, Arguments& arguments, std::string& why);

}  // namespace gs::host
