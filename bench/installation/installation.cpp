#include <cstdlib>
#include <system_error>

#include <installation/installation.hpp>

namespace gsbench::installation {
namespace {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code ignored;  // /proc is missing: relative to the current folder
  return fs::read_symlink("/proc/self/exe", ignored).parent_path();
}

// The specification has relative paths ignored.
fs::path absolute_from_environment(const char* variable) {
  const char* value = std::getenv(variable);
  const fs::path path = value != nullptr ? value : "";
  return path.is_absolute() ? path : fs::path();
}

}  // namespace

fs::path program(const std::string& name) {
  return program_folder() / name;
}

fs::path shipped(const std::string& name) {
  return (program_folder() / GSBENCH_DATA_FROM_PROGRAM / name).lexically_normal();
}

fs::path user_data(const std::string& name) {
  if (const fs::path data = absolute_from_environment("XDG_DATA_HOME"); !data.empty()) {
    return data / "gsbench" / name;
  }
  const fs::path home = absolute_from_environment("HOME");
  return home.empty() ? home : home / ".local" / "share" / "gsbench" / name;
}

}  // namespace gsbench::installation
