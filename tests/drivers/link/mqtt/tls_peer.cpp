#include "tls_peer.hpp"

#include <netinet/in.h>
#include <openssl/evp.h>
#include <openssl/x509.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <stdexcept>

namespace gsbench::test {
namespace {

constexpr int kPatienceMs = 10000;

void demand(bool met, const char* what) {
  if (!met) {
    throw std::runtime_error(what);
  }
}

// With a certificate of its own, which vouches for itself.
SSL_CTX* new_context() {
  SSL_CTX* const context = SSL_CTX_new(TLS_server_method());
  EVP_PKEY* const key = EVP_EC_gen("P-256");
  X509* const certificate = X509_new();
  demand(context != nullptr && key != nullptr && certificate != nullptr, "no certificate");
  ASN1_INTEGER_set(X509_get_serialNumber(certificate), 1);
  X509_gmtime_adj(X509_getm_notBefore(certificate), 0);
  X509_gmtime_adj(X509_getm_notAfter(certificate), 3600);
  X509_set_pubkey(certificate, key);
  X509_sign(certificate, key, EVP_sha256());
  SSL_CTX_use_certificate(context, certificate);
  SSL_CTX_use_PrivateKey(context, key);
  X509_free(certificate);
  EVP_PKEY_free(key);
  return context;
}

}  // namespace

TlsPeer::TlsPeer()
    : context_(new_context()), listening_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* const generic = reinterpret_cast<sockaddr*>(&address);
  demand(bind(listening_, generic, size) == 0 && listen(listening_, 1) == 0 &&
             getsockname(listening_, generic, &size) == 0,
         "no port");
  port_ = ntohs(address.sin_port);
  entry_ = std::async(std::launch::async, [this] { let_in(); });
}

TlsPeer::~TlsPeer() {
  entry_.wait();
  if (socket_ >= 0) {
    ::close(socket_);
  }
  ::close(listening_);
  SSL_free(connection_);
  SSL_CTX_free(context_);
}

void TlsPeer::let_in() {
  pollfd waited{listening_, POLLIN, 0};
  demand(poll(&waited, 1, kPatienceMs) == 1, "nobody connects");
  socket_ = accept(listening_, nullptr, nullptr);
  connection_ = SSL_new(context_);
  incoming_ = BIO_new(BIO_s_mem());
  outgoing_ = BIO_new(BIO_s_mem());
  SSL_set_bio(connection_, incoming_, outgoing_);
  while (SSL_accept(connection_) != 1) {
    send(sealed({}));
    receive_some();
  }
  std::array<char, 1024> connect{};
  while (SSL_read(connection_, connect.data(), static_cast<int>(connect.size())) <= 0) {
    send(sealed({}));
    receive_some();
  }
  send(sealed({std::string("\x20\x02\x00\x00", 4)}));  // CONNACK
}

void TlsPeer::receive_some() {
  std::array<char, 4096> bytes{};
  pollfd waited{socket_, POLLIN, 0};
  demand(poll(&waited, 1, kPatienceMs) == 1, "nothing comes from the client");
  const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
  demand(count > 0, "the client is gone");
  BIO_write(incoming_, bytes.data(), static_cast<int>(count));
}

// With whatever of the handshake is to be sent before.
std::string TlsPeer::sealed(const std::vector<std::string>& records) {
  for (const std::string& record : records) {
    SSL_write(connection_, record.data(), static_cast<int>(record.size()));
  }
  char* bytes = nullptr;
  const long count = BIO_get_mem_data(outgoing_, &bytes);
  std::string text(bytes, static_cast<std::size_t>(count));
  BIO_reset(outgoing_);
  return text;
}

void TlsPeer::send(const std::string& bytes) {
  demand(::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
             static_cast<ssize_t>(bytes.size()),
         "the client takes nothing");
}

void TlsPeer::send_together(const std::vector<std::string>& records) {
  entry_.wait();
  send(sealed(records));
}

void TlsPeer::send_damaged(const std::vector<std::string>& records) {
  entry_.wait();
  std::string bytes = sealed(records);
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  send(bytes);
}

std::string publish_packet(const std::string& topic, const std::string& payload) {
  const std::string rest = std::string(1, '\0') + static_cast<char>(topic.size()) + topic + payload;
  return std::string("\x30") + static_cast<char>(rest.size()) + rest;  // below 128 bytes
}

}  // namespace gsbench::test
