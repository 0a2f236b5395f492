// The far end of one MQTT connection over TLS that puts its records into the socket as a test wants
// them, which no broker does on demand. It lets anybody in.
#pragma once

#include <openssl/ssl.h>

#include <cstdint>
#include <future>
#include <string>
#include <vector>

namespace gsbench::test {

class TlsPeer {
 public:
  TlsPeer();
  ~TlsPeer();
  TlsPeer(const TlsPeer&) = delete;
  TlsPeer& operator=(const TlsPeer&) = delete;

  std::uint16_t port() const { return port_; }
  // Once a client has been let in. A record each, all in one piece.
  void send_together(const std::vector<std::string>& records);
  // The same, the last of them damaged on its way.
  void send_damaged(const std::vector<std::string>& records);

 private:
  void let_in();
  void receive_some();
  std::string sealed(const std::vector<std::string>& records);
  void send(const std::string& bytes);

  SSL_CTX* context_ = nullptr;
  SSL* connection_ = nullptr;
  BIO* incoming_ = nullptr;
  BIO* outgoing_ = nullptr;
  int listening_ = -1;
  int socket_ = -1;
  std::uint16_t port_ = 0;
  std::future<void> entry_;
};

std::string publish_packet(const std::string& topic, const std::string& payload);  // QoS 0

}  // namespace gsbench::test
