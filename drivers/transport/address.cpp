#include <arpa/inet.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include <transport/address.hpp>

namespace gsbench::transport {
namespace {

constexpr std::size_t kLongestHost = 253;  // of DNS
constexpr std::string_view kMark = "://";

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

std::optional<Address> read_address(const std::string& text) {
  const std::size_t mark = text.find(kMark);
  if (mark == std::string::npos) {
    return std::nullopt;
  }
  Address address;
  address.scheme = text.substr(0, mark);
  std::transform(address.scheme.begin(), address.scheme.end(), address.scheme.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  std::string rest = text.substr(mark + kMark.size());
  if (!rest.empty() && rest.back() == '/') {
    rest.pop_back();
  }
  const std::size_t colon = rest.rfind(':');
  if (colon == std::string::npos) {
    return std::nullopt;
  }
  const auto port = port_in(std::string_view(rest).substr(colon + 1));
  address.host = rest.substr(0, colon);
  const bool in_brackets =
      address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']';
  if (in_brackets) {
    address.host = address.host.substr(1, address.host.size() - 2);
  }
  if (!port || !(in_brackets ? is_ipv6(address.host) : is_host(address.host))) {
    return std::nullopt;
  }
  address.port = *port;
  return address;
}

std::string text_of(const Address& address) {
  const bool in_brackets = address.host.find(':') != std::string::npos;
  return address.scheme + "://" + (in_brackets ? '[' + address.host + ']' : address.host) + ':' +
         std::to_string(address.port);
}

}  // namespace gsbench::transport
