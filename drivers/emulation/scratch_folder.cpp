#include "scratch_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

namespace gsbench::emulation {

namespace fs = std::filesystem;
using drivers::Descriptor;
using drivers::Error;
using drivers::Result;

namespace {

constexpr const char* kPrefix = "gsbench-emulated-";
// The name until the folder is locked: remove_ownerless() ignores it.
constexpr const char* kNewPrefix = "gsbench-new-emulated-";

// In memory if possible: samples pass through files there.
fs::path place() {
  std::error_code error;
  return fs::is_directory("/dev/shm", error) ? fs::path("/dev/shm")
                                             : fs::temp_directory_path(error);
}

// Open and locked; closed if another process holds the lock.
Descriptor locked(const std::string& folder) {
  Descriptor lock(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
  if (lock.is_open() && flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    lock.close();
  }
  return lock;
}

void remove_ownerless() {
  std::error_code error;
  std::vector<fs::path> folders;
  for (fs::directory_iterator entry(place(), error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().filename().string().rfind(kPrefix, 0) == 0) {
      folders.push_back(entry->path());
    }
  }
  for (const fs::path& folder : folders) {
    if (const Descriptor lock = locked(folder.string()); lock.is_open()) {
      fs::remove_all(folder, error);
    }
  }
}

}  // namespace

Result<std::unique_ptr<ScratchFolder>> ScratchFolder::create() {
  remove_ownerless();
  std::string made = (place() / (std::string(kNewPrefix) + "XXXXXX")).string();
  std::unique_ptr<ScratchFolder> folder(new ScratchFolder);
  if (mkdtemp(made.data()) != nullptr) {
    folder->lock_ = locked(made);
    const std::string name = made.substr(made.rfind('-') + 1);
    folder->path_ = (place() / (kPrefix + name)).string();
  }
  if (!folder->lock_.is_open() || ::rename(made.c_str(), folder->path_.c_str()) != 0) {
    const int reason = errno;
    return Error{"emulated outlets: cannot create a folder for their files in " + place().string() +
                 ": " + std::strerror(reason)};
  }
  return folder;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path_.empty()) {
    fs::remove_all(path_, ignored);
  }
}

}  // namespace gsbench::emulation
