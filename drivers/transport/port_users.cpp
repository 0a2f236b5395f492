#include "port_users.hpp"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace gsbench::transport {
namespace {

namespace fs = std::filesystem;

bool has_open(const fs::path& process, const std::string& device, const std::string& except) {
  std::error_code none;
  fs::directory_iterator files(process / "fd", none);
  for (; !none && files != fs::directory_iterator(); files.increment(none)) {
    std::error_code unreadable;
    if (files->path().filename() != except &&
        fs::read_symlink(files->path(), unreadable) == device) {
      return true;
    }
  }
  return false;
}

}  // namespace

std::string user_of(const std::string& device, int except) {
  const std::string own = std::to_string(::getpid());
  std::error_code none;
  fs::directory_iterator processes("/proc", none);
  for (; !none && processes != fs::directory_iterator(); processes.increment(none)) {
    const std::string id = processes->path().filename();
    const bool is_process =
        std::all_of(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
    if (is_process &&
        has_open(processes->path(), device, id == own ? std::to_string(except) : "")) {
      std::string name;
      std::getline(std::ifstream(processes->path() / "comm"), name);
      return std::string("process ").append(id).append(" (").append(name).append(")");
    }
  }
  return "";
}

}  // namespace gsbench::transport
