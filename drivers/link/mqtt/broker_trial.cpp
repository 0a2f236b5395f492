#include "broker_trial.hpp"

#include <link_mqtt/mqtt_link.hpp>
#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <poll.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <fstream>
#include <memory>

#include <drivers/descriptor.hpp>
#include <transport/address.hpp>
#include <transport/transport.hpp>

namespace gsbench::link {

using drivers::Done;
using drivers::Error;
using drivers::Status;
using Clock = std::chrono::steady_clock;

namespace {

constexpr auto kForHandshake = std::chrono::seconds(5);
// With TLS 1.3, a broker refuses a client after the client's end of the handshake.
constexpr auto kForRefusal = std::chrono::milliseconds(300);

using Context = std::unique_ptr<SSL_CTX, decltype(&SSL_CTX_free)>;
using Session = std::unique_ptr<SSL, decltype(&SSL_free)>;

std::string newest_error() {
  const unsigned long error = ERR_peek_last_error();
  if (error == 0 || ERR_SYSTEM_ERROR(error)) {
    const int number = error == 0 ? errno : ERR_GET_REASON(error);
    return number == 0 ? "the far end has hung up" : std::strerror(number);
  }
  const char* const text = ERR_reason_error_string(error);
  return text != nullptr ? text : "OpenSSL error " + std::to_string(error);
}

enum class Progress : std::uint8_t { kDone, kFailed, kWaits };

// Repeats `step` until it is done, fails, or the deadline passes.
template <class Step>
Progress repeat(SSL* session, int descriptor, Clock::time_point until, Step step) {
  while (true) {
    ERR_clear_error();
    errno = 0;
    const int result = step(session);
    const int need = result > 0 ? SSL_ERROR_NONE : SSL_get_error(session, result);
    if (need != SSL_ERROR_WANT_READ && need != SSL_ERROR_WANT_WRITE) {
      return need == SSL_ERROR_NONE ? Progress::kDone : Progress::kFailed;
    }
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
    if (left.count() <= 0 ||
        !drivers::wait_for(descriptor, need == SSL_ERROR_WANT_READ ? POLLIN : POLLOUT,
                           static_cast<int>(left.count()))) {
      return Progress::kWaits;
    }
  }
}

// The certificate must be for this host.
void expect_host(SSL* session, const std::string& host) {
  X509_VERIFY_PARAM* const checks = SSL_get0_param(session);
  if (X509_VERIFY_PARAM_set1_ip_asc(checks, host.c_str()) != 1) {
    SSL_set_tlsext_host_name(session, host.c_str());
    X509_VERIFY_PARAM_set1_host(checks, host.c_str(), host.size());
  }
}

std::string trouble_with_tls(SSL* session, int descriptor, const std::string& ca_file) {
  const Progress handshake = repeat(session, descriptor, Clock::now() + kForHandshake, SSL_connect);
  if (handshake == Progress::kWaits) {
    return "does not answer the TLS handshake; there may be no TLS on this port";
  }
  const std::string why = handshake == Progress::kFailed ? newest_error() : "";
  if (const long refused = SSL_get_verify_result(session); refused != X509_V_OK) {
    const bool fits_its_ca =
        refused == X509_V_ERR_HOSTNAME_MISMATCH || refused == X509_V_ERR_IP_ADDRESS_MISMATCH ||
        refused == X509_V_ERR_CERT_HAS_EXPIRED || refused == X509_V_ERR_CERT_NOT_YET_VALID;
    return "has a certificate that is refused: " +
           std::string(X509_verify_cert_error_string(refused)) +
           (fits_its_ca ? "" : "; the CA file is \"" + ca_file + '"');
  }
  if (handshake == Progress::kFailed) {
    return "fails the TLS handshake: " + why +
           (why.find("alert") == std::string::npos ? "; there may be no TLS on this port" : "");
  }
  const Progress after = repeat(session, descriptor, Clock::now() + kForRefusal, [](SSL* peeked) {
    char byte = 0;
    return SSL_peek(peeked, &byte, 1);
  });
  return after == Progress::kFailed ? "ends the TLS connection: " + newest_error() : "";
}

}  // namespace

std::string trouble_with(const BrokerUrl& broker, const std::string& ca_file) {
  const auto port =
      transport::make_transport(transport::text_of({"tcp", broker.host, broker.port}));
  if (const Status opened = port->open(); !opened.ok()) {
    return opened.error().substr(port->port().size() + 2);
  }
  const Context context(SSL_CTX_new(TLS_client_method()), SSL_CTX_free);
  const Session session(context ? SSL_new(context.get()) : nullptr, SSL_free);
  if (!session || SSL_set_fd(session.get(), port->descriptor()) != 1) {
    return "";
  }
  if (!broker.tls) {
    return repeat(session.get(), port->descriptor(), Clock::now() + kForHandshake, SSL_connect) ==
                   Progress::kDone
               ? "speaks TLS on this port; its address begins with mqtts://"
               : "";
  }
  SSL_CTX_load_verify_locations(context.get(), ca_file.c_str(), nullptr);
  SSL_set_verify(session.get(), SSL_VERIFY_PEER, nullptr);
  expect_host(session.get(), broker.host);
  return trouble_with_tls(session.get(), port->descriptor(), ca_file);
}

Status check_ca_file(const std::string& path) {
  errno = 0;
  if (std::ifstream file(path); file.peek() == std::ifstream::traits_type::eof()) {
    return Error{errno != 0 ? std::strerror(errno) : "it is empty"};
  }
  const Context context(SSL_CTX_new(TLS_client_method()), SSL_CTX_free);
  ERR_clear_error();
  if (context && SSL_CTX_load_verify_locations(context.get(), path.c_str(), nullptr) != 1) {
    return Error{newest_error()};
  }
  return Done{};
}

}  // namespace gsbench::link
