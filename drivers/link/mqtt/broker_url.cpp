#include <arpa/inet.h>
#include <link_mqtt/broker_url.hpp>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

namespace gsbench::link {
namespace {

constexpr std::size_t kLongestHost = 253;  // of DNS

bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return inet_pton(AF_INET6, host.substr(0, host.find('%')).c_str(), &address) == 1;
}

bool is_host(const std::string& host) {
  return !host.empty() && host.size() <= kLongestHost &&
         std::all_of(host.begin(), host.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_' || c >= 0x80;
         });
}

std::optional<std::uint16_t> port_in(std::string_view text) {
  constexpr std::size_t kMostDigits = 5;
  std::uint16_t port = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), port);
  return read.ec == std::errc() && read.ptr == text.data() + text.size() && port > 0 &&
                 text.size() <= kMostDigits
             ? std::optional(port)
             : std::nullopt;
}

}  // namespace

std::optional<BrokerUrl> read_broker_url(const std::string& text) {
  BrokerUrl url;
  std::string lower = text.substr(0, text.find("://"));
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  url.tls = lower == "mqtts";
  if ((!url.tls && lower != "mqtt") || lower.size() == text.size()) {
    return std::nullopt;
  }
  std::string rest = text.substr(lower.size() + 3);
  if (!rest.empty() && rest.back() == '/') {
    rest.pop_back();
  }
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string::npos) {
    return std::nullopt;
  }
  const auto port = port_in(std::string_view(rest).substr(colon + 1));
  url.host = rest.substr(0, colon);
  const bool in_brackets = url.host.size() > 2 && url.host.front() == '[' && url.host.back() == ']';
  if (in_brackets) {
    url.host = url.host.substr(1, url.host.size() - 2);
  }
  if (!port || !(in_brackets ? is_ipv6(url.host) : is_host(url.host))) {
    return std::nullopt;
  }
  url.port = *port;
  return url;
}

std::string text_of(const BrokerUrl& url) {
  const bool in_brackets = url.host.find(':') != std::string::npos;
  return (url.tls ? "mqtts://" : "mqtt://") + (in_brackets ? '[' + url.host + ']' : url.host) +
         ':' + std::to_string(url.port);
}

}  // namespace gsbench::link
