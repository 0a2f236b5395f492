#include "outlet_links.hpp"

#include "port_keys.hpp"
#include "station_kind.hpp"

#include <algorithm>
#include <fstream>

#include <fmt/format.h>

#include <link/combined_link.hpp>
#include <profile/files.hpp>

namespace gsbench::station {
namespace {

constexpr std::size_t kLongestUrl = 300;

bool begins_with(const std::string& text, const char* beginning) {
  return text.rfind(beginning, 0) == 0;
}

bool is_broker_url(const std::string& url) {
  if (url.size() > kLongestUrl || !(begins_with(url, "mqtt://") || begins_with(url, "mqtts://"))) {
    return false;
  }
  const std::size_t host = url.find("://") + 3;
  const std::size_t colon = url.find_first_of("/:", host);
  if (colon == std::string::npos || colon == host || url[colon] != ':') {
    return false;
  }
  const std::string port = url.substr(colon + 1);
  return !port.empty() && port.size() <= 5 &&
         port.find_first_not_of("0123456789") == std::string::npos && std::stoi(port) >= 1 &&
         std::stoi(port) <= 65535;
}

std::vector<std::string> outlet_ids(const keys::Table& table) {
  std::vector<std::string> ids;
  for (const keys::PlacedText& outlet : table.texts("outlets")) {
    if (std::count(ids.begin(), ids.end(), outlet.text) > 0) {
      table.refuse(outlet.at, fmt::format("outlet \"{}\" is listed twice", outlet.text));
    }
    ids.push_back(outlet.text);
  }
  return ids;
}

void read_mqtt(const keys::Table& table, const std::string& file_path, PhysicalOutlets& outlets) {
  link::MqttOptions& mqtt = outlets.mqtt;
  mqtt.url = table.text("url");
  if (!is_broker_url(mqtt.url)) {
    table.refuse("url", fmt::format("url is \"{}\"; it must be mqtts://host:port, or "
                                    "mqtt://host:port without TLS",
                                    mqtt.url));
  }
  const auto beside = [&](const std::optional<std::string>& path) {
    return path ? profile::resolve(*path, file_path) : std::string();
  };
  mqtt.ca_file = beside(table.find_text("ca_file"));
  if (begins_with(mqtt.url, "mqtts://") && mqtt.ca_file.empty()) {
    table.refuse_missing("ca_file", "the CA certificate that verifies the broker: ca_file = …");
  }
  mqtt.user = table.find_text("user").value_or("");
  mqtt.outlets = outlet_ids(table);
  outlets.password_file = beside(table.find_text("password_file"));
}

std::string first_line(const std::string& path) {
  std::string line;
  if (!std::getline(std::ifstream(path), line)) {
    throw keys::ConfigurationError(path +
                                   ": cannot read a password from the first line of this file");
  }
  return line;
}

}  // namespace

std::vector<keys::Key> link_keys() {
  return {
      keys::table("serial", "Serial ports of the outlets.",
                  {keys::array("ports", keys::text("", ""),
                               "ports with one outlet each, in a station without `[[outlet]]`; no "
                               "answer on a port is a fault")
                       .permits("array of device paths or `tcp://host:port`, at least one")
                       .or_else("the `link` of each `[[outlet]]`"),
                   keys::whole("baud", "bit/s", 9600, 4000000, "baud rate of the serial ports")
                       .by_default(transport::kBaud)}),
      keys::table(
          "mqtt", "The MQTT broker of the outlets.",
          {keys::text("url", "address of the broker")
               .permits("`mqtts://host:port`, or `mqtt://host:port` without TLS")
               .require(),
           keys::text("ca_file", "CA certificate to verify the broker with")
               .permits("path")
               .or_else("required with `mqtts`"),
           keys::text("user", "user name of the bench at the broker"),
           keys::text("password_file", "file with the password in its first line").permits("path"),
           keys::array("outlets", keys::id("", kLongestId, ""),
                       "outlets to use, in a station without `[[outlet]]`; a listed outlet "
                       "that is not found is a fault")
               .permits("array of ids, each once")
               .or_else("all that are found, or each `[[outlet]]` with `link = \"mqtt\"`")})};
}

PhysicalOutlets read_links(const keys::Table& top, const std::string& file_path) {
  PhysicalOutlets outlets;
  if (top.has("serial")) {
    const keys::Table serial = top.table("serial");
    for (const keys::PlacedText& port : serial.texts("ports")) {
      require_port(serial, "ports", port.at, port.text);
      outlets.serial.ports.push_back(port.text);
    }
    outlets.serial.baud = read_baud(serial);
  }
  if (top.has("mqtt")) {
    read_mqtt(top.table("mqtt"), file_path, outlets);
  }
  return outlets;
}

std::unique_ptr<link::Link> make_link(PhysicalOutlets outlets) {
  std::vector<std::unique_ptr<link::Link>> links;
  if (!outlets.serial.ports.empty()) {
    links.push_back(std::make_unique<link::FramedLink>(outlets.serial));
  }
  if (!outlets.mqtt.url.empty()) {
    if (!outlets.password_file.empty()) {
      outlets.mqtt.password = first_line(outlets.password_file);
    }
    links.push_back(std::make_unique<link::MqttLink>(outlets.mqtt));
  }
  return std::make_unique<link::CombinedLink>(std::move(links));
}

}  // namespace gsbench::station
