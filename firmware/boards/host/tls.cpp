#include "tls.hpp"

#include <openssl/err.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gs::host {

// OpenSSL's callback for each certificate of the chain.
struct TlsCheck {
  static int passes(int accepted, X509_STORE_CTX* chain) {
    if (accepted == 0) {
      const auto* const session = static_cast<SSL*>(
          X509_STORE_CTX_get_ex_data(chain, SSL_get_ex_data_X509_STORE_CTX_idx()));
      static_cast<Tls*>(SSL_CTX_get_app_data(SSL_get_SSL_CTX(session)))
          ->refuse(X509_STORE_CTX_get_error(chain));
    }
    return accepted;
  }
};

Tls::~Tls() {
  SSL_CTX_free(context_);
}

bool Tls::start(const std::string& ca_file, const std::string& host, std::string& why) {
  ca_file_ = ca_file;
  errno = 0;
  if (std::ifstream file(ca_file); file.peek() == std::ifstream::traits_type::eof()) {
    why = errno != 0 ? std::strerror(errno) : "it is empty";
    return false;
  }
  context_ = SSL_CTX_new(TLS_client_method());
  if (context_ == nullptr) {
    why = "OpenSSL cannot be used";
    return false;
  }
  ERR_clear_error();
  if (SSL_CTX_load_verify_locations(context_, ca_file.c_str(), nullptr) != 1) {
    const char* const text = ERR_reason_error_string(ERR_peek_last_error());
    why = text != nullptr ? text : "it holds no certificate";
    return false;
  }
  SSL_CTX_set_app_data(context_, this);
  SSL_CTX_set_verify(context_, SSL_VERIFY_PEER, &TlsCheck::passes);
  X509_VERIFY_PARAM* const checks = SSL_CTX_get0_param(context_);
  if (X509_VERIFY_PARAM_set1_ip_asc(checks, host.c_str()) != 1) {
    X509_VERIFY_PARAM_set1_host(checks, host.c_str(), host.size());
  }
  return true;
}

void Tls::refuse(long verify_error) {
  const bool fits_its_ca = verify_error == X509_V_ERR_HOSTNAME_MISMATCH ||
                           verify_error == X509_V_ERR_IP_ADDRESS_MISMATCH ||
                           verify_error == X509_V_ERR_CERT_HAS_EXPIRED ||
                           verify_error == X509_V_ERR_CERT_NOT_YET_VALID;
  refusal_ = X509_verify_cert_error_string(verify_error);
  if (!fits_its_ca) {
    refusal_ += "; the CA file is \"" + ca_file_ + '"';
  }
}

}  // namespace gs::host
