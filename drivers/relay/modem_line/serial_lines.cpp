#include <fcntl.h>
#include <relay_modem_line/modem_line_sense.hpp>
#include <sys/ioctl.h>
#include <termios.h>

#include <cstring>
#include <thread>

namespace gsbench::relay {
namespace {

using drivers::Descriptor;
using drivers::Error;
using drivers::Result;

Result<Descriptor> open_for_modem_lines(const std::string& port) {
  // O_NONBLOCK: open() must not wait for a carrier.
  Descriptor descriptor(::open(port.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  termios settings{};
  if (!descriptor.is_open() || ::tcgetattr(descriptor.get(), &settings) != 0) {
    return Error{port + ": opening it for its modem lines: " + std::strerror(errno)};
  }
  // Without flow control, which would drive RTS and stop at CTS. HUPCL: outputs off at the end.
  ::cfmakeraw(&settings);
  settings.c_cflag &= ~static_cast<tcflag_t>(CRTSCTS);
  settings.c_cflag |= CLOCAL | HUPCL;
  if (::tcsetattr(descriptor.get(), TCSANOW, &settings) != 0 ||
      ::ioctl(descriptor.get(), TIOCEXCL) != 0) {
    return Error{port + ": setting it up for its modem lines: " + std::strerror(errno)};
  }
  return descriptor;
}

}  // namespace

ModemLineSystem this_machine() {
  return {
      open_for_modem_lines,
      [](int descriptor, unsigned long request, int* bits) {
        return ::ioctl(descriptor, request, bits);
      },
      [] { return std::chrono::steady_clock::now(); },
      [](std::chrono::steady_clock::duration duration) { std::this_thread::sleep_for(duration); }};
}

}  // namespace gsbench::relay
