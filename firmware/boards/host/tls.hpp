// The check of a broker's certificate. libmosquitto's own does not say why it refuses one.
#pragma once

#include <string>

struct ssl_ctx_st;

namespace gs::host {

class Tls {
 public:
  Tls() = default;
  ~Tls();
  Tls(const Tls&) = delete;
  Tls& operator=(const Tls&) = delete;

  // A certificate must be for `host` and signed by the CA of the file. Returns false with the
  // reason in `why` if the file cannot be read or holds no certificate in PEM form.
  bool start(const std::string& ca_file, const std::string& host, std::string& why);
  // For MOSQ_OPT_SSL_CTX. Null: not started.
  ssl_ctx_st* context() const { return context_; }

  // Why the newest certificate was refused; empty: it was not.
  const std::string& refusal() const { return refusal_; }
  void forget_refusal() { refusal_.clear(); }

 private:
  void refuse(long verify_error);
  friend struct TlsCheck;

  ssl_ctx_st* context_ = nullptr;
  std::string ca_file_;
  std::string refusal_;
};

}  // namespace gs::host
