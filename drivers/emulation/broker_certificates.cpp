#include "broker_certificates.hpp"

#include "broker_program.hpp"

#include <filesystem>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr const char* kDays = "14";  // the longest run, with room for a clock that is off

std::vector<std::string> request(const std::string& subject, const std::string& key,
                                 const std::string& certificate) {
  return {"openssl", "req",      "-x509", "-newkey", "ec",    "-pkeyopt", "ec_paramgen_curve:P-256",
          "-noenc",  "-days",    kDays,   "-subj",   subject, "-keyout",  key,
          "-out",    certificate};
}

}  // namespace

Result<Certificates> make_certificates(const std::string& folder) {
  const Certificates made = {folder + "/ca.pem", folder + "/server.pem", folder + "/server.key"};
  const std::string ca_key = folder + "/ca.key";
  const std::string log = folder + "/openssl.log";

  std::vector<std::string> words = request("/CN=gsbench private broker's CA", ca_key, made.ca_file);
  words.insert(words.end(), {"-addext", "keyUsage=critical,keyCertSign"});
  Status done = run_to_make(made.ca_file, words, log);
  if (!done.ok()) {
    return Error{done.error()};
  }
  words = request("/CN=127.0.0.1", made.server_key_file, made.server_file);
  words.insert(words.end(),
               {"-CA", made.ca_file, "-CAkey", ca_key, "-addext", "subjectAltName=IP:127.0.0.1",
                "-addext", "basicConstraints=critical,CA:FALSE"});
  done = run_to_make(made.server_file, words, log);
  std::error_code none;
  std::filesystem::remove(ca_key, none);  // nobody signs another one
  if (!done.ok()) {
    return Error{done.error()};
  }
  return made;
}

}  // namespace gsbench::emulation
