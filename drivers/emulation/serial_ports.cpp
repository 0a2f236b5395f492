#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <emulation/serial_ports.hpp>

namespace gsbench::emulation {
namespace {

constexpr const char* kLibrary = "libgsbench-pty.so";
// Set for the program begun anew: it does not begin anew again.
constexpr const char* kBegunAnew = "GSBENCH_BEGUN_ANEW";

std::vector<std::string> own_arguments() {
  std::ifstream file("/proc/self/cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(file, word, '\0');) {
    words.push_back(word);
  }
  return words;
}

}  // namespace

bool pseudo_terminals_are_serial_ports() {
  // Only the preloaded library makes one of this place.
  char where[8];
  return readlink("/sys/class/tty/pts/0", where, sizeof where) > 0;
}

drivers::Status restart_with_pseudo_terminals() {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  const std::filesystem::path library = self.parent_path() / kLibrary;
  if (error || !std::filesystem::exists(library, error)) {
    return drivers::Error{library.string() + " is missing: emulated serial ports need it"};
  }
  if (library.string().find_first_of(" :") != std::string::npos) {
    return drivers::Error{library.string() +
                          ": cannot be preloaded from a path with a space or a colon in it"};
  }
  if (std::getenv(kBegunAnew) != nullptr) {
    return drivers::Error{library.string() + " was preloaded and has no effect"};
  }
  setenv(kBegunAnew, "1", 1);
  const char* before = std::getenv("LD_PRELOAD");
  const std::string preload =
      library.string() + (before != nullptr && *before != '\0' ? ':' + std::string(before) : "");
  setenv("LD_PRELOAD", preload.c_str(), 1);
  std::vector<std::string> words = own_arguments();
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  execv(self.c_str(), argv.data());
  return drivers::Error{self.string() + ": " + std::strerror(errno)};
}

}  // namespace gsbench::emulation
