#include "certified_broker.hpp"

#include <test_support/demand.hpp>
#include <test_support/output_of.hpp>
#include <test_support/waiting.hpp>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include <transport/transport.hpp>

namespace gsbench::test {
namespace {

constexpr const char* kKey = " -newkey ec -pkeyopt ec_paramgen_curve:P-256 -noenc ";

void make_certificates(const TemporaryFolder& folder, const Certificate& certificate) {
  const std::string made =
      output_of("cd " + folder.file("") + " && openssl req -x509" + kKey +
                "-days 14 -subj /CN=ca -keyout ca.key -out ca.pem -addext "
                "keyUsage=critical,keyCertSign 2>&1"
                " && openssl req" +
                kKey +
                "-subj /CN=broker -keyout broker.key -out broker.csr 2>&1"
                " && printf 'subjectAltName=" +
                certificate.host +
                "' > names"
                " && openssl x509 -req -in broker.csr -CA ca.pem -CAkey ca.key -days " +
                std::to_string(certificate.days) + " -extfile names -out broker.pem 2>&1")
          .text;
  if (!std::filesystem::exists(folder.file("broker.pem"))) {
    throw std::runtime_error("openssl: " + made);
  }
}

}  // namespace

CertifiedBroker::CertifiedBroker(const Certificate& certificate, const std::string& address)
    : address_(address), port_(demand(emulation::LoopbackPort::reserve())) {
  make_certificates(folder_, certificate);
  launch("certfile " + folder_.file("broker.pem") + "\nkeyfile " + folder_.file("broker.key") +
         (certificate.requires_clients ? "\nrequire_certificate true\ncafile " + ca_file() : "") +
         "\n");
}

CertifiedBroker::CertifiedBroker() : port_(demand(emulation::LoopbackPort::reserve())) {
  launch("");
}

std::string CertifiedBroker::url(const std::string& scheme) const {
  return scheme + "://" + address_ + ':' + port();
}

void CertifiedBroker::launch(const std::string& tls) {
  const bool in_brackets = address_.front() == '[';
  const std::string bound = in_brackets ? address_.substr(1, address_.size() - 2) : address_;
  const std::string configuration = folder_.write(
      "mosquitto.conf", std::string(geteuid() == 0 ? "user root\n" : "") +
                            "allow_anonymous true\nlistener " + port() + ' ' + bound + '\n' + tls);
  mosquitto_ = std::make_unique<emulation::Child>(demand(emulation::Child::start(
      {{"/usr/sbin/mosquitto", "-c", configuration}, folder_.file("log")})));
  const auto listens = transport::make_transport(url("tcp"));
  if (!until([&] { return listens->open().ok() || !mosquitto_->running(); }) ||
      !mosquitto_->running()) {
    throw std::runtime_error("mosquitto: " + folder_.read("log"));
  }
}

}  // namespace gsbench::test
