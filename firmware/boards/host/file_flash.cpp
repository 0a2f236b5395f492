#include "file_flash.hpp"

#include <fcntl.h>
#include <shared_memory_io/shared_memory.hpp>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstring>

namespace gs::host {

namespace {

using shared_memory_io::kFlashSlotBytes;
using shared_memory_io::kMagic;

constexpr std::uint32_t kErased = 0xFFFFFFFFu;

off_t place(int slot, std::size_t offset) {
  return static_cast<off_t>(offsetof(shared_memory_io::SharedMemory, flash) +
                            static_cast<std::size_t>(slot) * kFlashSlotBytes + offset);
}

bool write_at(int file, off_t at, const void* bytes, std::size_t size) {
  return pwrite(file, bytes, size, at) == static_cast<ssize_t>(size);
}

}  // namespace

FileFlash::~FileFlash() {
  if (file_ >= 0) {
    ::close(file_);
  }
}

bool FileFlash::open(const std::string& path, std::string& why) {
  file_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, S_IRUSR | S_IWUSR);
  struct stat state {};
  if (file_ < 0 || fstat(file_, &state) != 0) {
    why = path + ": " + std::strerror(errno);
    return false;
  }
  if (!S_ISREG(state.st_mode)) {
    why = path + ": is no ordinary file";
    return false;
  }
  if (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    why =
        path + ": " + (errno == EWOULDBLOCK ? "is used by another process" : std::strerror(errno));
    return false;
  }
  std::uint32_t magic = 0;
  if (state.st_size > 0 &&
      (pread(file_, &magic, sizeof magic, 0) != sizeof magic || magic != kMagic)) {
    why = path + ": not the flash of an outlet";
    return false;
  }
  return true;
}

bool FileFlash::erase(int slot) {
  struct stat state {};
  if (fstat(file_, &state) != 0 || state.st_nlink == 0) {
    return false;
  }
  std::array<std::uint8_t, kFlashSlotBytes> erased{};
  erased.fill(0xFF);
  return write_at(file_, 0, &kMagic, sizeof kMagic) &&
         write_at(file_, place(slot, 0), erased.data(), erased.size());
}

// Like flash: bits change from 1 to 0 only.
bool FileFlash::program(int slot, std::size_t offset, std::uint32_t word) {
  const std::uint32_t left = read(slot, offset) & word;
  return write_at(file_, place(slot, offset), &left, sizeof left);
}

std::uint32_t FileFlash::read(int slot, std::size_t offset) const {
  std::uint32_t word = kErased;
  const bool there = pread(file_, &word, sizeof word, place(slot, offset)) == sizeof word;
  return there ? word : kErased;
}

}  // namespace gs::host
