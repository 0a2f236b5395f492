#include "broker_configuration.hpp"
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include <emulation/listening.hpp>
#include <emulation/private_broker.hpp>
#include <transport/transport.hpp>

namespace gsbench::emulation {

using drivers::Done;
using drivers::Error;
using drivers::Result;
using drivers::Status;

namespace {

constexpr auto kPatience = std::chrono::seconds(10);  // start-up takes milliseconds

// Debian installs it in a folder that only root's PATH contains.
std::string mosquitto_program() {
  const char* const kSystem = "/usr/sbin/mosquitto";
  return access(kSystem, X_OK) == 0 ? kSystem : "mosquitto";
}

// One descriptor for each outlet: the usual limit of 1024 is too low for a thousand outlets.
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
  const auto listens = transport::make_transport("tcp://127.0.0.1:" + std::to_string(port));
  const auto until = std::chrono::steady_clock::now() + kPatience;
  while (std::chrono::steady_clock::now() < until) {
    const bool accepts = listens->open().ok();
    // If our broker has ended, another process accepts on this port.
    if (!child.running()) {
      return Error{"mosquitto ended during start-up on port " + std::to_string(port) + ": " +
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
      return Error{
          "an outlet cannot log in as \"" + id +
          "\": an id has letters, digits, '-', '_' and '.' only, and \"bench\" is reserved"};
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
  if (done.ok()) {
    done = make_certificates(folder);
  }
  if (!done.ok()) {
    return Error{done.error()};
  }

  // Reserved until the broker listens on it.
  const auto reserved = LoopbackPort::reserve();
  if (!reserved.ok()) {
    return Error{reserved.error()};
  }
  const std::uint16_t port = reserved.value().number();
  done = write_configuration(folder, port);
  if (!done.ok()) {
    return Error{done.error()};
  }
  auto launched = launch(folder, port);
  if (!launched.ok()) {
    return Error{launched.error()};
  }
  PrivateBroker broker(launched.take());
  broker.folder_ = folder;
  broker.port_ = port;
  broker.ca_file_ = folder + kCaFile;
  broker.bench_ = logins.front();
  for (auto login = logins.begin() + 1; login != logins.end(); ++login) {
    broker.outlets_[login->user] = *login;
  }
  return broker;
}

Status PrivateBroker::restart() {
  child_.stop();
  return launch(folder_, port_).move_to(child_);
}

}  // namespace gsbench::emulation
