#include "run_steps.hpp"
#include <fcntl.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

#include <fmt/format.h>

#include <station/station_lock.hpp>
#include <transport/transport.hpp>

namespace gsbench::station {
namespace {

constexpr const char* kFolder = "/tmp";
constexpr mode_t kForAllUsers = 0666;

[[noreturn]] void fail(const std::string& path, const char* doing) {
  throw std::runtime_error(fmt::format("{}: {}: {}", path, doing, std::strerror(errno)));
}

// Linux refuses O_CREAT on another user's file in /tmp (fs.protected_regular), so an existing file
// is opened without it.
drivers::Descriptor open_lock_file(const std::string& path) {
  for (int attempt = 0; attempt < 2; ++attempt) {
    drivers::Descriptor existing(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    if (existing.is_open() || errno != ENOENT) {
      return existing;
    }
    drivers::Descriptor created(
        ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kForAllUsers));
    if (created.is_open()) {
      (void)::fchmod(created.get(), kForAllUsers);  // whatever the umask
      return created;
    }
  }
  return drivers::Descriptor();
}

std::string content_of(const drivers::Descriptor& file) {
  std::array<char, 512> text{};
  const ssize_t count = ::pread(file.get(), text.data(), text.size(), 0);
  return {text.data(), count > 0 ? static_cast<std::size_t>(count) : 0U};
}

std::string user_name() {
  const passwd* user = ::getpwuid(::getuid());
  return user != nullptr ? user->pw_name : std::to_string(::getuid());
}

// The same text for all names of one port.
std::vector<std::string> identities_of(const std::string& given) {
  const std::string port = transport::in_one_form(given);
  const std::size_t scheme_end = port.find("://");
  if (scheme_end == std::string::npos) {
    return {device_of(port)};
  }
  const std::string scheme = port.substr(0, scheme_end);
  const std::size_t host = scheme_end + 3;
  const std::size_t path = std::min(port.find('/', host), port.size());
  const std::size_t colon = std::min(port.rfind(':', path), path);
  const bool is_broker = scheme == "mqtt" || scheme == "mqtts";
  std::vector<std::string> identities;
  for (const std::string& address : transport::addresses_of(port.substr(host, colon - host))) {
    identities.push_back(is_broker ? fmt::format("mqtt://{}{}", address, port.substr(path))
                                   : fmt::format("{}://{}{}", scheme, address, port.substr(colon)));
  }
  return identities;
}

}  // namespace

std::string device_of(const std::string& port) {
  std::error_code ignored;  // a device that does not exist has its name only
  const std::string device =
      port.rfind('/', 0) == 0 ? std::filesystem::weakly_canonical(port, ignored).string() : port;
  return device.empty() ? port : device;
}

std::vector<std::string> lock_files(const std::string& port) {
  std::vector<std::string> files;
  for (const std::string& identity : identities_of(port)) {
    std::string name;
    for (const char character : identity) {
      const bool plain = std::isalnum(static_cast<unsigned char>(character)) != 0 ||
                         character == '.' || character == '-';
      name += plain ? character : '_';
    }
    files.push_back(fmt::format("{}/gsbench-{}.lock", kFolder, name));
  }
  return files;
}

StationLock::StationLock(const std::vector<std::string>& ports, const std::string& doing) {
  std::set<std::string> paths;
  for (const std::string& port : ports) {
    for (const std::string& path : port.empty() ? std::vector<std::string>() : lock_files(port)) {
      if (paths.insert(path).second) {
        take(path, port, doing);
      }
    }
  }
}

void StationLock::take(const std::string& path, const std::string& port, const std::string& doing) {
  drivers::Descriptor file = open_lock_file(path);
  if (!file.is_open()) {
    fail(path, "the lock of a port cannot be opened");
  }
  if (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno != EWOULDBLOCK) {
      fail(path, "the lock of a port cannot be taken");
    }
    throw StationBusy(fmt::format("{}: in use by another bench: {}", port, content_of(file)));
  }
  const std::string owner = fmt::format("user {}, process {} (gsbench), {}, since {}", user_name(),
                                        ::getpid(), doing, utc_now());
  const auto size = static_cast<ssize_t>(owner.size());
  if (::ftruncate(file.get(), 0) != 0 ||
      ::pwrite(file.get(), owner.data(), owner.size(), 0) != size) {
    fail(path, "the lock of a port cannot be written");
  }
  files_.push_back(std::move(file));
}

StationLock::~StationLock() = default;

std::string lock_holder(const std::string& port) {
  for (const std::string& path : lock_files(port)) {
    const drivers::Descriptor file(::open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW));
    // A lock that was taken here is released with the descriptor.
    if (file.is_open() && ::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
      return content_of(file);
    }
  }
  return "";
}

}  // namespace gsbench::station
