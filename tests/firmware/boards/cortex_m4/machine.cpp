#include "machine.hpp"

namespace gs::test {

using gsbench::test::demand;

Machine::Machine(std::vector<std::string> words) {
  demand(line_->open());
  const std::string port = std::to_string(cable_->outlet_end());
  if (words.front() == "qemu-system-arm") {
    words.insert(words.begin() + 1,
                 {"-display", "none", "-monitor", "none", "-nic", "none", "-chardev",
                  "socket,id=line,host=127.0.0.1,nodelay=on,port=" + port, "-serial",
                  "chardev:line", "-gdb", "tcp:127.0.0.1:" + std::to_string(debugger_.number())});
  } else {
    words.insert(words.begin() + 1, {"--tcp", "127.0.0.1:" + port});
  }
  child_ = demand(gsbench::emulation::Child::start({words, ""}));
}

std::string Machine::debugger() const {
  return "tcp://127.0.0.1:" + std::to_string(debugger_.number());
}

}  // namespace gs::test
