// Addresses as text, by the same rule for TCP ports and brokers.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace gsbench::transport {

struct Address {
  std::string scheme;  // lower case
  std::string host;    // a name or an address; an IPv6 address has no brackets
  std::uint16_t port = 0;
};

// "scheme://host:port". The scheme may be in upper case, an IPv6 address is in brackets, and a
// slash may follow the port: "TCP://[::1]:5000/". nullopt: `text` has another form. Looks at
// nothing but the text.
std::optional<Address> read_address(const std::string& text);

// The same text for all forms of an address: "tcp://[::1]:5000".
std::string text_of(const Address& address);

}  // namespace gsbench::transport
