#include "address.hpp"

#include <arpa/inet.h>

#include <algorithm>
#include <cctype>
#include <charconv>

namespace gs::host {
namespace {

bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return inet_pton(AF_INET6, host.substr(0, host.find('%')).c_str(), &address) == 1;
}

bool is_host(const std::string& host) {
  constexpr std::size_t kLongestHost = 253;  // of DNS
  return !host.empty() && host.size() <= kLongestHost &&
         std::all_of(host.begin(), host.end(), [](unsigned char c) {
           return std::isalnum(c) != 0 || c == '.' || c == '-' || c == '_' || c >= 0x80;
         });
}

bool read_port(const std::string& text, std::uint16_t& port) {
  constexpr std::size_t kMostDigits = 5;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, port);
  return number.ec == std::errc() && number.ptr == end && port > 0 && text.size() <= kMostDigits;
}

}  // namespace

bool read_address(const std::string& text, Address& address) {
  const std::size_t mark = text.find("://");
  address.scheme = mark == std::string::npos ? "" : text.substr(0, mark);
  std::transform(address.scheme.begin(), address.scheme.end(), address.scheme.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string rest = mark == std::string::npos ? text : text.substr(mark + 3);
  if (!rest.empty() && rest.back() == '/') {
    rest.pop_back();
  }
  const std::size_t colon = rest.rfind(':');
  if (mark == 0 || colon == std::string::npos || !read_port(rest.substr(colon + 1), address.port)) {
    return false;
  }
  address.host = rest.substr(0, colon);
  if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']') {
    address.host = address.host.substr(1, address.host.size() - 2);
    return is_ipv6(address.host);
  }
  return is_host(address.host);
}

std::string text_of(const std::string& host, const std::string& port) {
  return (host.find(':') == std::string::npos ? host : '[' + host + ']') + ':' + port;
}

}  // namespace gs::host
