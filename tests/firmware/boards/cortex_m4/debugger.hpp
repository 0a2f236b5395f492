// Client of gdb's remote protocol in qemu: reads an emulated processor's memory and changes its
// execution.
#pragma once

#include "machine.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace gs::test {

// The machine is halted in its scope.
class Debugger {
 public:
  explicit Debugger(const Machine& machine);
  ~Debugger();
  Debugger(const Debugger&) = delete;
  Debugger& operator=(const Debugger&) = delete;

  std::vector<std::uint8_t> memory(std::uint32_t address, std::size_t count);
  void write(std::uint32_t address, const std::vector<std::uint8_t>& bytes);
  void go_to(std::uint32_t address);
  std::uint32_t program_counter();
  // Runs a function until it returns to `return_to`, an address that the function itself must not
  // execute. The machine's previous execution is not restored.
  void call(std::uint32_t function, std::uint32_t argument, std::uint32_t return_to);

 private:
  void set_register(unsigned number, std::uint32_t value);
  std::string ask(const std::string& packet);
  void demand_ok(const std::string& packet);
  void send(const std::string& text);
  std::string next_packet(const std::string& after);

  std::unique_ptr<gsbench::transport::Transport> connection_;
  std::string received_;
};

// The address of a symbol in an image, by `nm`. A C++ function needs its parameter list.
std::uint32_t address_of_symbol(const std::string& image, const std::string& symbol);

}  // namespace gs::test
