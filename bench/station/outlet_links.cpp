#include "outlet_links.hpp"

#include "port_keys.hpp"
#include "station_kind.hpp"
#include <link_mqtt/broker_url.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include <link/combined_link.hpp>
#include <profile/files.hpp>

namespace gsbench::station {
namespace {

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

// The path of a file beside the station file, and the place that names it.
void read_path(const keys::Table& table, const std::string& key, const std::string& file_path,
               std::string& path, std::string& at) {
  if (const auto given = table.find_text(key)) {
    path = profile::resolve(*given, file_path);
    at = fmt::format("{}:{}:{}", file_path, table.at(key).line, table.at(key).column);
  }
}

void read_mqtt(const keys::Table& table, const std::string& file_path, PhysicalOutlets& outlets) {
  link::MqttOptions& mqtt = outlets.mqtt;
  const std::string given = table.text("url");
  const auto url = link::read_broker_url(given);
  if (!url) {
    table.refuse("url",
                 fmt::format("url is \"{}\"; it must be mqtts://host:port, or mqtt://host:port "
                             "without TLS, with a port from 1 to 65535; an IPv6 address is in "
                             "brackets: mqtts://[::1]:8883",
                             given));
  }
  mqtt.url = link::text_of(*url);
  read_path(table, "ca_file", file_path, mqtt.ca_file, outlets.ca_file_at);
  if (url->tls && mqtt.ca_file.empty()) {
    table.refuse_missing("ca_file", "the CA certificate that verifies the broker: ca_file = …");
  }
  if (!url->tls && !mqtt.ca_file.empty()) {
    table.refuse("ca_file", "ca_file has no effect with mqtt://; for TLS use mqtts://");
  }
  mqtt.user = table.find_text("user").value_or("");
  mqtt.outlets = outlet_ids(table);
  read_path(table, "password_file", file_path, outlets.password_file, outlets.password_file_at);
  if (mqtt.user.empty() && !outlets.password_file.empty()) {
    table.refuse("password_file",
                 "password_file has no effect without user, the bench's user name at the broker");
  }
}

[[noreturn]] void refuse_file(const std::string& at, const char* key, const std::string& path,
                              const std::string& why) {
  throw keys::ConfigurationError(fmt::format("{}: {} is \"{}\", {}", at, key, path, why));
}

void require_ca(const PhysicalOutlets& outlets) {
  const bool uses_tls = outlets.mqtt.url.rfind("mqtts:", 0) == 0;
  if (uses_tls && !outlets.ca_file_at.empty()) {
    if (const auto read = link::check_ca_file(outlets.mqtt.ca_file); !read.ok()) {
      refuse_file(outlets.ca_file_at, "ca_file", outlets.mqtt.ca_file,
                  "from which no CA certificate can be read: " + read.error());
    }
  }
}

constexpr std::size_t kLongestPassword = 65535;  // of a string in MQTT

// The first line, without what editors of other systems add: a byte order mark at its beginning and
// a carriage return at its end.
std::string password_of(const PhysicalOutlets& outlets) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  const auto refuse = [&](const std::string& why) {
    refuse_file(outlets.password_file_at, "password_file", outlets.password_file, why);
  };
  errno = 0;
  std::ifstream file(outlets.password_file, std::ios::binary);
  std::string line;
  if (!std::getline(file, line) && errno != 0) {
    refuse(fmt::format("which cannot be read: {}", std::strerror(errno)));
  }
  if (line.rfind(kByteOrderMark, 0) == 0) {
    line.erase(0, kByteOrderMark.size());
  }
  if (!line.empty() && line.back() == '\r') {
    line.pop_back();
  }
  if (line.find('\0') != std::string::npos) {
    refuse("which has a NUL in its first line; a password file is UTF-8 text");
  }
  if (line.empty()) {
    refuse("whose first line is empty; it must be the password");
  }
  if (line.size() > kLongestPassword) {
    refuse(fmt::format("whose first line has {} bytes; a password has at most {}", line.size(),
                       kLongestPassword));
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
               .permits(
                   "`mqtts://host:port`, or `mqtt://host:port` without TLS; an IPv6 address is in "
                   "brackets")
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
    require_ca(outlets);
    if (!outlets.password_file.empty()) {
      outlets.mqtt.password = password_of(outlets);
    }
    links.push_back(std::make_unique<link::MqttLink>(outlets.mqtt));
  }
  return std::make_unique<link::CombinedLink>(std::move(links));
}

}  // namespace gsbench::station
