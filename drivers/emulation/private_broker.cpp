#include "broker_certificates.hpp"
#include "broker_configuration.hpp"
#include "broker_program.hpp"
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

#include <emulation/private_broker.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;
using emulation::Child;

namespace {

constexpr auto kPatience = std::chrono::seconds(10);  // it takes milliseconds to start
constexpr int kPortsTried = 5;

sockaddr_in loopback(std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  return address;
}

// One that is free now; somebody else may take it before it is used. 0: none.
std::uint16_t free_port() {
  const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address = loopback(0);
  socklen_t length = sizeof address;
  const bool bound = s >= 0 &&
                     bind(s, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0 &&
                     getsockname(s, reinterpret_cast<sockaddr*>(&address), &length) == 0;
  if (s >= 0) {
    close(s);
  }
  return bound ? ntohs(address.sin_port) : std::uint16_t{0};
}

bool accepts_connections(std::uint16_t port) {
  const int s = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = loopback(port);
  const bool accepted =
      s >= 0 && connect(s, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  if (s >= 0) {
    close(s);
  }
  return accepted;
}

// Debian keeps it where only root's PATH looks.
std::string mosquitto_program() {
  const char* const kSystem = "/usr/sbin/mosquitto";
  return access(kSystem, X_OK) == 0 ? kSystem : "mosquitto";
}

// Each outlet is one descriptor; the usual limit of 1024 is too few for a thousand of them.
void allow_many_connections(pid_t pid) {
  rlimit files{};
  if (prlimit(pid, RLIMIT_NOFILE, nullptr, &files) == 0) {
    files.rlim_cur = files.rlim_max;
    prlimit(pid, RLIMIT_NOFILE, &files, nullptr);
  }
}

Result<Child> launch(const std::string& folder, std::uint16_t port) {
  const std::string log = folder + "/mosquitto.log";
  auto started = Child::start({{mosquitto_program(), "-c", folder + "/mosquitto.conf"}, log});
  if (!started.ok()) {
    return started;
  }
  Child child = started.take();
  allow_many_connections(child.pid());
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < until) {
    const bool accepts = accepts_connections(port);
    // What accepts is another's where ours has ended.
    if (!child.running()) {
      return Error{"mosquitto ended at its start on port " + std::to_string(port) + ": " +
                   text_of(log)};
    }
    if (accepts) {
      return child;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return Error{"mosquitto does not accept connections on port " + std::to_string(port) + ": " +
               text_of(log)};
}

Status check_ids(const std::vector<std::string>& ids) {
  for (const std::string& id : ids) {
    const bool readable = !id.empty() && std::all_of(id.begin(), id.end(), [](unsigned char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             c == '-' || c == '_' || c == '.';
    });
    if (!readable || id == kBenchUser) {
      return Error{"no outlet can log in as \"" + id +
                   "\": letters, digits, '-', '_' and '.' make an id, and \"bench\" is the bench"};
    }
  }
  return Done{};
}

Status make_private_folder(const std::string& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  if (!failed) {
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all, failed);
  }
  if (failed) {
    return Error{folder + ": " + failed.message()};
  }
  return Done{};
}

}  // namespace

Result<PrivateBroker> PrivateBroker::start(const Options& options) {
  Status done = check_ids(options.outlets);
  if (done.ok()) {
    done = make_private_folder(options.folder);
  }
  if (!done.ok()) {
    return Error{done.error()};
  }
  const std::string folder = std::filesystem::absolute(options.folder).string();

  std::vector<Login> logins = {{kBenchUser, new_password()}};
  for (const std::string& id : options.outlets) {
    logins.push_back({id, new_password()});
  }
  done = write_logins(folder, logins);
  if (!done.ok()) {
    return Error{done.error()};
  }
  std::optional<Certificates> certificates;
  if (options.tls) {
    const auto made = make_certificates(folder);
    if (!made.ok()) {
      return Error{made.error()};
    }
    certificates = made.value();
  }

  std::string why = "no port of 127.0.0.1 is free";
  for (int attempt = 0; attempt < kPortsTried; ++attempt) {
    const std::uint16_t port = free_port();
    const auto configured = write_configuration(folder, port, certificates);
    if (!configured.ok()) {
      return Error{configured.error()};
    }
    auto launched = launch(folder, port);
    if (!launched.ok()) {
      why = launched.error();
      continue;
    }
    PrivateBroker broker(launched.take());
    broker.folder_ = folder;
    broker.port_ = port;
    broker.ca_file_ = certificates ? certificates->ca_file : "";
    broker.bench_ = logins.front();
    for (auto login = logins.begin() + 1; login != logins.end(); ++login) {
      broker.outlets_[login->user] = *login;
    }
    return broker;
  }
  return Error{why};
}

std::string PrivateBroker::url() const {
  return (ca_file_.empty() ? "mqtt://127.0.0.1:" : "mqtts://127.0.0.1:") + std::to_string(port_);
}

Status PrivateBroker::restart() {
  child_.stop();
  auto launched = launch(folder_, port_);
  if (!launched.ok()) {
    return Error{launched.error()};
  }
  child_ = launched.take();
  return Done{};
}

}  // namespace gsbench::emulation
