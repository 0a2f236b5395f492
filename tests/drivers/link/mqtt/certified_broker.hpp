// A Mosquitto process with a certificate made for a test.
#pragma once

#include <test_support/temporary_folder.hpp>

#include <memory>
#include <string>

#include <emulation/child.hpp>
#include <emulation/listening.hpp>

namespace gsbench::test {

struct Certificate {
  std::string host = "IP:127.0.0.1";  // subjectAltName
  int days = 14;                      // valid for; below 0: it has expired
  bool requires_clients = false;      // the broker asks clients for one, too
};

class CertifiedBroker {
 public:
  // Blocks until the broker accepts connections at `address`. Throws std::runtime_error.
  explicit CertifiedBroker(const Certificate& certificate,
                           const std::string& address = "127.0.0.1");
  // Without TLS.
  CertifiedBroker();

  std::string url(const std::string& scheme = "mqtts") const;
  std::string port() const { return std::to_string(port_.number()); }
  std::string ca_file() const { return folder_.file("ca.pem"); }

 private:
  void launch(const std::string& tls);

  TemporaryFolder folder_;
  std::string address_ = "127.0.0.1";
  emulation::LoopbackPort port_;
  std::unique_ptr<emulation::Child> mosquitto_;
};

}  // namespace gsbench::test
