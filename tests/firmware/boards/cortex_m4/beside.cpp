#include "beside.hpp"

#include <fstream>
#include <iterator>

namespace gs::test {
namespace {

// In the board's PSRAM, above the part that the firmware uses. The linker gets it, too.
constexpr std::uint32_t kCodeAddress = GSBENCH_BESIDE_ADDRESS;
constexpr std::uint32_t kReturnAddress = kCodeAddress + 0x7000;
constexpr std::uint32_t kDataAddress = kCodeAddress + 0x8000;

Bytes content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  Bytes bytes(std::istreambuf_iterator<char>(file), {});
  if (bytes.empty() || bytes.size() > kReturnAddress - kCodeAddress) {
    throw std::runtime_error(path + " is empty or too long");
  }
  return bytes;
}

}  // namespace

ProgramBeside::ProgramBeside(const Machine& machine, const std::string& program,
                             const std::string& entry)
    : debugger_(machine), entry_(address_of_symbol(program + ".elf", entry)), next_(kDataAddress) {
  debugger_.write(kCodeAddress, content_of(program + ".bin"));
}

std::uint32_t ProgramBeside::put(const Bytes& bytes) {
  const std::uint32_t address = next_;
  debugger_.write(address, bytes);
  next_ += (static_cast<std::uint32_t>(bytes.size()) + 7U) & ~7U;
  return address;
}

void ProgramBeside::call(std::uint32_t argument) {
  debugger_.call(entry_, argument, kReturnAddress);
}

}  // namespace gs::test
