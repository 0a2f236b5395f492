#include "pty.hpp"

#include <fcntl.h>
#include <termios.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace gsbench::test {

Pty::Pty(std::string path)
    : path_(std::move(path)), master_(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC | O_NONBLOCK)) {
  char device[64] = {};
  if (!master_.is_open() || grantpt(master_.get()) != 0 || unlockpt(master_.get()) != 0 ||
      ptsname_r(master_.get(), device, sizeof device) != 0) {
    throw std::runtime_error("cannot create a pseudo-terminal");
  }
  slave_ = drivers::Descriptor(::open(device, O_RDWR | O_NOCTTY | O_CLOEXEC));
  termios settings{};
  if (!slave_.is_open() || tcgetattr(slave_.get(), &settings) != 0) {
    throw std::runtime_error(std::string(device) + " cannot be opened");
  }
  cfmakeraw(&settings);
  tcsetattr(slave_.get(), TCSANOW, &settings);
  std::filesystem::create_symlink(device, path_);
}

Pty::~Pty() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace gsbench::test
