// A program that runs on the emulated board beside an image, whose functions it calls. It is built
// by gs_program_beside() and loaded by the debugger.
#pragma once

#include "debugger.hpp"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace gs::test {

using Bytes = std::vector<std::uint8_t>;

// The layout is the same on both processors: plain numbers of the same sizes.
template <class T>
Bytes bytes_of(const T* values, std::size_t count = 1) {
  Bytes bytes(count * sizeof *values);
  std::memcpy(bytes.data(), values, bytes.size());
  return bytes;
}

class ProgramBeside {
 public:
  // The firmware must have set up the processor: wait for its hello. It is halted from now on.
  // `program`: path of its files, without .elf and .bin.
  ProgramBeside(const Machine& machine, const std::string& program, const std::string& entry);

  // Places data one after another in the processor's memory, aligned to 8 bytes, and returns the
  // address.
  std::uint32_t put(const Bytes& bytes);
  template <class T>
  void get(std::uint32_t address, std::vector<T>& values) {
    const Bytes bytes = debugger_.memory(address, values.size() * sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
  }
  // Calls the program's entry and waits until it returns, at most kPatience.
  void call(std::uint32_t argument);

 private:
  Debugger debugger_;
  std::uint32_t entry_;
  std::uint32_t next_;  // free address for data
};

}  // namespace gs::test
