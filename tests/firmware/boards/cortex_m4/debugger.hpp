// qemu's end of gdb's remote protocol: to look into an emulated processor and to lead it astray.
#pragma once

#include "machine.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace gs::test {

// The machine stands still in its scope.
class Debugger {
 public:
  explicit Debugger(const Machine& machine);
  ~Debugger();
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;

  std::vector<std::uint8_t> memory(std::uint32_t address, std::size_t count);
  void go_to(std::uint32_t address);

 private:
  std::string ask(const std::string& packet);
  std::string next_packet(const std::string& after);

  Socket socket_;
  std::string received_;
};

// The address of a symbol in an image, by `nm`.
std::uint32_t address_of_symbol(const std::string& image, const std::string& symbol);

}  // namespace gs::test
