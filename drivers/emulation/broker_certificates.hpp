// A certificate authority that signs one server certificate and is then forgotten.
#pragma once

#include <string>

#include <drivers/result.hpp>

namespace gsbench::emulation {

struct Certificates {
  std::string ca_file;
  std::string server_file;
  std::string server_key_file;
};

// For 127.0.0.1, elliptic curve P-256, with the openssl program.
drivers::Result<Certificates> make_certificates(const std::string& folder);

}  // namespace gsbench::emulation
