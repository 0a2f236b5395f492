#include "shared_memory_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <new>
#include <utility>

#include <app/application.hpp>

namespace gsbench::emulation {

using drivers::Error;
using drivers::Result;
using drivers::Status;
using gs::shared_memory_io::kRingSamples;
using gs::shared_memory_io::SharedMemory;

namespace {

// The emulated board's external memory; the terminals are at its start.
constexpr std::size_t kFileBytes = std::size_t{16} << 20;
static_assert(sizeof(SharedMemory) <= kFileBytes);

}  // namespace

Result<SharedMemoryFile> SharedMemoryFile::create(const std::string& folder,
                                                  const SharedMemorySettings& settings) {
  SharedMemoryFile file;
  file.path_ = folder + "/" + settings.id + ".terminals";
  file.doorbell_ = folder + "/" + settings.id + ".doorbell";
  const Descriptor memory(::open(file.path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
  if (!memory.is_open() || ftruncate(memory.get(), kFileBytes) != 0) {
    return Error{file.path_ + ": " + std::strerror(errno)};
  }
  void* mapped =
      mmap(nullptr, sizeof(SharedMemory), PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (mapped == MAP_FAILED) {
    return Error{file.path_ + ": " + std::strerror(errno)};
  }
  file.terminals_.reset(new (mapped) SharedMemory{});
  SharedMemory* const terminals = file.terminals_.get();
  std::memset(terminals->flash, 0xFF, sizeof terminals->flash);
  terminals->sample_rate_hz = settings.sample_rate_hz;
  terminals->nominal_hz = settings.nominal_hz;
  terminals->counts_per_pu = settings.counts_per_pu;
  terminals->instance = settings.instance;
  gs::app::set_text(terminals->id, settings.id.c_str());
  terminals->magic = gs::shared_memory_io::kMagic;
  const Status listening = listen_on(file.doorbell_).move_to(file.listening_);
  return listening.ok() ? Result<SharedMemoryFile>(std::move(file)) : Error{listening.error()};
}

void SharedMemoryFile::Unmap::operator()(SharedMemory* mapped) const noexcept {
  munmap(mapped, sizeof(SharedMemory));
}

SharedMemoryFile::~SharedMemoryFile() {
  if (terminals_ != nullptr) {
    unlink(path_.c_str());
    unlink(doorbell_.c_str());
  }
}

void SharedMemoryFile::write(const std::int16_t* samples, std::size_t count) {
  const std::uint32_t written = terminals_->written;
  for (std::size_t i = 0; i < count; ++i) {
    terminals_->ring[(written + i) % kRingSamples] = samples[i];
  }
  __atomic_store_n(&terminals_->written, written + static_cast<std::uint32_t>(count),
                   __ATOMIC_RELEASE);
}

void SharedMemoryFile::ring() {
  // A restarted outlet connects again.
  Descriptor newer(accept4(listening_.get(), nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (newer.is_open()) {
    connection_ = std::move(newer);
  }
  const char byte = 1;
  if (connection_.is_open() && ::send(connection_.get(), &byte, 1, MSG_NOSIGNAL) < 0 &&
      errno != EAGAIN) {
    connection_.close();
  }
}

std::uint32_t SharedMemoryFile::behind() const {
  return terminals_->written - terminals_->taken;
}

}  // namespace gsbench::emulation
