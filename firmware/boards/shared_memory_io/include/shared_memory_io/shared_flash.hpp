// An emulated outlet's flash: bytes in the terminals, that outlive its process.
#pragma once

#include <settings_storage/settings_storage.hpp>
#include <shared_memory_io/shared_memory.hpp>

namespace gs::shared_memory_io {

class SharedFlash final : public settings_storage::Flash {
 public:
  explicit SharedFlash(SharedMemory& terminals) : terminals_(terminals) {}

  bool erase(int slot) override;
  bool program(int slot, std::size_t offset, std::uint32_t word) override;
  std::uint32_t read(int slot, std::size_t offset) const override;

 private:
  volatile std::uint32_t& word(int slot, std::size_t offset) const;

  SharedMemory& terminals_;
};

}  // namespace gs::shared_memory_io
