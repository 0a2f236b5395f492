#include "serial_line.hpp"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gs::host {

int SerialLine::connect(std::string& far_end, std::string& why) {
  far_end = device_;
  const int port = ::open(device_.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  termios raw{};
  if (port >= 0 && tcgetattr(port, &raw) == 0) {
    cfmakeraw(&raw);
    raw.c_cflag |= CLOCAL | CREAD;
    raw.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS | CSTOPB);
    // A read without bytes fails with EAGAIN only if it waits for one.
    raw.c_cc[VMIN] = 1;
    raw.c_cc[VTIME] = 0;
    if (cfsetspeed(&raw, B921600) == 0 && tcsetattr(port, TCSANOW, &raw) == 0) {
      return port;
    }
  }
  why = device_ + ": " + (errno == ENOTTY ? "is not a serial port" : std::strerror(errno));
  if (port >= 0) {
    ::close(port);
  }
  return -1;
}

}  // namespace gs::host
