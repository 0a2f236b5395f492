// Addresses on the command line: of a broker, or of a TCP line.
#pragma once

#include <cstdint>
#include <string>

namespace gs::host {

struct Address {
  std::string scheme;  // lower case; empty: none
  std::string host;    // a name or an address; an IPv6 address has no brackets
  std::uint16_t port = 0;
};

// "[scheme://]host:port". The scheme may be in upper case, an IPv6 address is in brackets, and a
// slash may follow the port. Returns false for another form. Looks at nothing but the text.
bool read_address(const std::string& text, Address& address);

// "[::1]:5000"
std::string text_of(const std::string& host, const std::string& port);

}  // namespace gs::host
