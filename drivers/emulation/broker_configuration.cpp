#include "broker_configuration.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include <fmt/format.h>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Status;

namespace {

constexpr const char* kAccess =
    "user bench\n"
    "topic read gs/+/hello\n"
    "topic read gs/+/up\n"
    "topic write gs/+/down\n"
    "\n"
    "pattern write gs/%u/hello\n"
    "pattern write gs/%u/up\n"
    "pattern read gs/%u/down\n";

// The broker keeps the order of an outlet's messages only while none waits for a free in-flight
// slot, so the in-flight limit is MQTT's largest. The queue is unlimited: a slow bench loses
// nothing. Sessions are saved every second or two, so that a restarted broker keeps the outlets'
// messages until the bench reconnects.
constexpr const char* kLimits =
    "persistence true\n"
    "autosave_interval 1\n"
    "allow_anonymous false\n"
    "max_inflight_messages 65535\n"
    "max_queued_messages 0\n"
    "max_keepalive 60\n"
    "set_tcp_nodelay true\n"
    "sys_interval 0\n"
    "log_dest stdout\n"
    "log_type error\n"
    "log_type warning\n"
    "log_type notice\n"
    "connection_messages false\n";

constexpr const char* kServerFile = "/server.pem";
constexpr const char* kServerKeyFile = "/server.key";
constexpr const char* kDays = "14";  // the longest run, with a margin for a wrong clock

std::vector<std::string> request(const std::string& subject, const std::string& key,
                                 const std::string& certificate) {
  return {"openssl", "req",      "-x509", "-newkey", "ec",    "-pkeyopt", "ec_paramgen_curve:P-256",
          "-noenc",  "-days",    kDays,   "-subj",   subject, "-keyout",  key,
          "-out",    certificate};
}

// Runs the program to its end. If it did not create `product`, the error quotes its output.
Status run_to_make(const std::string& product, const std::vector<std::string>& words,
                   const std::string& log) {
  constexpr auto kPatience = std::chrono::seconds(20);  // a key takes milliseconds
  auto started = Child::start({words, log});
  if (!started.ok()) {
    return Error{started.error()};
  }
  Child program = started.take();
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (program.running() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  std::error_code none;
  if (program.running() || !std::filesystem::exists(product, none) ||
      std::filesystem::file_size(product, none) == 0) {
    return Error{words.front() + " did not create " + product + ": " + text_of(log)};
  }
  return Done{};
}

Status write_private(const std::string& file, const std::string& text) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  // The mode is set before the text is written.
  if (out && ::chmod(file.c_str(), 0600) == 0 && out << text && out.flush()) {
    return Done{};
  }
  return Error{file + ": " + std::strerror(errno)};
}

}  // namespace

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

std::string new_password() {
  std::random_device device;
  std::string password;
  for (int word = 0; word < 4; ++word) {
    password += fmt::format("{:08x}", device());
  }
  return password;
}

Status make_certificates(const std::string& folder) {
  const std::string ca_key = folder + "/ca.key";
  const std::string log = folder + "/openssl.log";
  std::vector<std::string> words =
      request("/CN=gsbench private broker's CA", ca_key, folder + kCaFile);
  words.insert(words.end(), {"-addext", "keyUsage=critical,keyCertSign"});
  Status done = run_to_make(folder + kCaFile, words, log);
  if (!done.ok()) {
    return done;
  }
  words = request("/CN=127.0.0.1", folder + kServerKeyFile, folder + kServerFile);
  words.insert(words.end(),
               {"-CA", folder + kCaFile, "-CAkey", ca_key, "-addext", "subjectAltName=IP:127.0.0.1",
                "-addext", "basicConstraints=critical,CA:FALSE"});
  done = run_to_make(folder + kServerFile, words, log);
  std::error_code none;
  std::filesystem::remove(ca_key, none);  // no further certificate can be signed
  return done;
}

Status write_logins(const std::string& folder, const std::vector<Login>& logins) {
  std::string lines;
  for (const Login& login : logins) {
    lines += login.user + ':' + login.password + '\n';
  }
  // Hashed in place: other users could read passwords on a command line.
  const std::string file = folder + "/passwords";
  const std::string log = folder + "/mosquitto_passwd.log";
  Status done = write_private(file, lines);
  if (done.ok()) {
    done = run_to_make(file, {"mosquitto_passwd", "-U", file}, log);
  }
  if (!done.ok()) {
    return done;
  }
  if (text_of(file).find(":$7$") == std::string::npos) {
    return Error{"mosquitto_passwd did not hash the passwords: " + text_of(log)};
  }
  return write_private(folder + "/access", kAccess);
}

Status write_configuration(const std::string& folder, std::uint16_t port) {
  std::string text = kLimits;
  // Started as root, Mosquitto would switch to a user that cannot read this folder.
  if (geteuid() == 0) {
    text += "user root\n";
  }
  text += "persistence_location " + folder + "/\n";
  text += "password_file " + folder + "/passwords\n";
  text += "acl_file " + folder + "/access\n";
  text += "listener " + std::to_string(port) + " 127.0.0.1\n";
  text += "certfile " + folder + kServerFile + '\n';
  text += "keyfile " + folder + kServerKeyFile + '\n';
  text += "tls_version tlsv1.3\n";
  return write_private(folder + "/mosquitto.conf", text);
}

}  // namespace gsbench::emulation
