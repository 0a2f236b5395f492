#include "new_record.hpp"

#include "schema.hpp"
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

constexpr off_t kReserve_bytes = 256 * 1024;

[[noreturn]] void refuse_to_create(const std::string& path, int cause) {
  throw StoreError(path + ": cannot be created: " + std::strerror(cause));
}

// O_EXCL: fails for an existing file, also if two runs start at the same time.
int create(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    refuse_to_create(path, errno);
  }
  return file;
}

std::vector<std::uint8_t> empty_record() {
  Database database = Database::in_memory();
  database.execute("PRAGMA application_id = " + std::to_string(kApplicationId));
  database.execute("PRAGMA user_version = " + std::to_string(kSchemaVersion));
  database.execute(schema_sql());
  return database.bytes();
}

}  // namespace

void create_record(const std::string& path) {
  ::close(create(path));
  const std::string made = path + "-new";
  const int file = create(made);
  const std::vector<std::uint8_t> bytes = empty_record();
  const ssize_t written = ::write(file, bytes.data(), bytes.size());
  int cause = written < 0 ? errno : written < static_cast<ssize_t>(bytes.size()) ? ENOSPC : 0;
  ::close(file);
  if (cause == 0 && ::rename(made.c_str(), path.c_str()) != 0) {
    cause = errno;
  }
  if (cause != 0) {
    ::unlink(made.c_str());
    ::unlink(path.c_str());
    refuse_to_create(path, cause);
  }
}

std::string reserve_of(const std::string& path) {
  return path + "-reserve";
}

Reserve::Reserve(const std::string& record) : path_(reserve_of(record)), file_(create(path_)) {
  const int cause =
      ::flock(file_, LOCK_EX) != 0 ? errno : ::posix_fallocate(file_, 0, kReserve_bytes);
  if (cause != 0) {
    free();
    refuse_to_create(record, cause);
  }
}

void Reserve::free() noexcept {
  if (file_ >= 0) {
    ::unlink(path_.c_str());
    ::close(std::exchange(file_, -1));  // the disk has its room back once it is closed
  }
}

bool is_in_progress(const std::string& path) {
  const int file = ::open(reserve_of(path).c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) {
    return false;
  }
  const bool is_locked = ::flock(file, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  ::close(file);
  return is_locked;
}

}  // namespace gsbench::record
