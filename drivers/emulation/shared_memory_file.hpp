// The terminals of one emulated outlet (shared_memory_io/shared_memory.hpp), in a file that its
// emulator maps as memory. The doorbell is a Unix socket: one byte for each block of samples wakes
// the outlet.
#pragma once

#include <shared_memory_io/shared_memory.hpp>

#include <cstdint>
#include <memory>
#include <string>

#include <drivers/result.hpp>
#include <emulation/listening.hpp>

namespace gsbench::emulation {

struct SharedMemorySettings {
  std::string id;
  std::uint32_t instance = 0;
  std::int32_t sample_rate_hz = 8000;
  std::int32_t nominal_hz = 50;
  float counts_per_pu = 0.0F;
};

class SharedMemoryFile {
 public:
  // Creates the file and the doorbell. The outlet's flash, in the file, is erased.
  static drivers::Result<SharedMemoryFile> create(const std::string& folder,
                                                  const SharedMemorySettings& settings);
  SharedMemoryFile(SharedMemoryFile&& other) noexcept = default;
  SharedMemoryFile& operator=(SharedMemoryFile&& other) noexcept = delete;
  ~SharedMemoryFile();

  const std::string& path() const { return path_; }
  const std::string& doorbell() const { return doorbell_; }
  gs::shared_memory_io::SharedMemory& terminals() const { return *terminals_; }

  void write(const std::int16_t* samples, std::size_t count);
  void ring();
  // Samples that the outlet has not read yet.
  std::uint32_t behind() const;

 private:
  struct Unmap {
    void operator()(gs::shared_memory_io::SharedMemory* mapped) const noexcept;
  };

  SharedMemoryFile() = default;

  std::string path_;
  std::string doorbell_;
  std::unique_ptr<gs::shared_memory_io::SharedMemory, Unmap> terminals_;
  Descriptor listening_;
  Descriptor connection_;
};

}  // namespace gsbench::emulation
