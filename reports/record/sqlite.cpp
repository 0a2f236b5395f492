#include "sqlite.hpp"

#include "new_record.hpp"
#include <sqlite3.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <limits>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

constexpr int kBusyTimeout_ms = 2000;

std::string with_system_cause(const char* what, int system_errno) {
  if (system_errno == 0) {
    return what;
  }
  return std::string(what) + ": " + std::strerror(system_errno);
}

std::string cause_of(sqlite3* handle, int code) {
  const int last_errno = errno;
  const int system_errno = handle != nullptr ? sqlite3_system_errno(handle) : 0;
  switch (code & 0xff) {
    case SQLITE_FULL:
      return "no space left on the device";
    case SQLITE_READONLY:
      return "the file or its folder is not writable";
    case SQLITE_CANTOPEN:
      return with_system_cause("cannot be opened", system_errno);
    case SQLITE_IOERR:
      // SQLite keeps no cause if a COMMIT cannot be written.
      return with_system_cause("input/output error", system_errno != 0 ? system_errno : last_errno);
    case SQLITE_NOTADB:
      return "not a gsbench record";
    case SQLITE_CORRUPT:
      return "the record is damaged";
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      return "in use by another process";
    default:
      return handle != nullptr ? sqlite3_errmsg(handle) : sqlite3_errstr(code);
  }
}

// If no other process has the database open, it is one plain file afterwards.
void recover(const std::string& absolute) {
  std::error_code ignored;  // a folder that cannot be written
  if (!std::filesystem::exists(absolute + "-wal", ignored) &&
      !std::filesystem::exists(absolute + "-journal", ignored)) {
    return;
  }
  sqlite3* handle = nullptr;
  if (sqlite3_open_v2(absolute.c_str(), &handle, SQLITE_OPEN_READWRITE, nullptr) == SQLITE_OK) {
    // Fails while the process that writes the record has it open.
    if (sqlite3_exec(handle, "PRAGMA journal_mode = DELETE", nullptr, nullptr, nullptr) ==
        SQLITE_OK) {
      std::filesystem::remove(reserve_of(absolute), ignored);
    }
  }
  sqlite3_close(handle);
}

}  // namespace

Database::Database(const std::string& path, Mode mode) : path_(path) {
  const int flags = mode == Mode::kRead ? SQLITE_OPEN_READONLY : SQLITE_OPEN_READWRITE;
  // SQLite never takes an absolute path for a URI or for ":memory:".
  const std::string absolute = std::filesystem::absolute(path).string();
  if (mode == Mode::kRead) {
    recover(absolute);
  }
  const int code = sqlite3_open_v2(absolute.c_str(), &handle_, flags, nullptr);
  if (code != SQLITE_OK) {
    const std::string cause = cause_of(handle_, code);
    sqlite3_close(handle_);
    throw StoreError(path_ + ": " + cause);
  }
  sqlite3_busy_timeout(handle_, kBusyTimeout_ms);
  // A record may come from an untrusted place: its schema must not run code or write.
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(handle_, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
}

Database Database::in_memory() {
  Database database;
  database.path_ = ":memory:";
  const int code = sqlite3_open(":memory:", &database.handle_);
  if (code != SQLITE_OK) {
    database.fail_with(code);
  }
  return database;
}

Database::Database(Database&& other) noexcept
    : path_(std::move(other.path_)), handle_(std::exchange(other.handle_, nullptr)) {}

Database::~Database() {
  sqlite3_close(handle_);
}

std::vector<std::uint8_t> Database::bytes() const {
  sqlite3_int64 size = 0;
  unsigned char* content = sqlite3_serialize(handle_, "main", &size, 0);
  if (content == nullptr) {
    fail_with(SQLITE_NOMEM);
  }
  std::vector<std::uint8_t> copy(content, content + size);
  sqlite3_free(content);
  return copy;
}

void Database::fail(const std::string& cause) const {
  throw StoreError(path_ + ": " + cause);
}
void Database::fail_with(int code) const {
  fail(cause_of(handle_, code));
}

void Database::execute(const std::string& sql) {
  errno = 0;
  const int code = sqlite3_exec(handle_, sql.c_str(), nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) {
    fail_with(code);
  }
}

Statement Database::prepare(const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(handle_, sql.c_str(), -1, &statement, nullptr);
  if (code != SQLITE_OK) {
    fail_with(code);
  }
  return {*this, statement};
}

void Database::transact(const std::function<void()>& work) {
  execute("BEGIN IMMEDIATE");
  try {
    work();
    execute("COMMIT");
  } catch (...) {
    try {
      execute("ROLLBACK");
    } catch (const StoreError&) {
      // SQLite has already rolled back (disk full, I/O error); the first error is rethrown below.
    }
    throw;
  }
}

Statement::Statement(const Database& database, sqlite3_stmt* handle)
    : database_(database), handle_(handle) {}
Statement::~Statement() {
  sqlite3_finalize(handle_);
}

void Statement::check(int code) const {
  if (code != SQLITE_OK) {
    database_.fail_with(code);
  }
}

bool Statement::step() {
  errno = 0;
  const int code = sqlite3_step(handle_);
  if (code == SQLITE_ROW) {
    return true;
  }
  if (code != SQLITE_DONE) {
    database_.fail_with(code);
  }
  return false;
}

void Statement::reset() {
  check(sqlite3_reset(handle_));
}

void Statement::bind_integer(int parameter, std::int64_t value) {
  check(sqlite3_bind_int64(handle_, parameter, value));
}

void Statement::bind(int parameter, double value) {
  check(sqlite3_bind_double(handle_, parameter, value));
}

void Statement::bind(int parameter, const std::string& value) {
  check(sqlite3_bind_text64(handle_, parameter, value.data(), value.size(), SQLITE_TRANSIENT,
                            SQLITE_UTF8));
}

void Statement::bind(int parameter, const std::vector<std::uint8_t>& value) {
  check(sqlite3_bind_blob64(handle_, parameter, value.data(), value.size(), SQLITE_TRANSIENT));
}

void Statement::get(int column, std::int64_t& value) const {
  value = sqlite3_column_int64(handle_, column);
}

void Statement::get(int column, std::uint64_t& value) const {
  value = static_cast<std::uint64_t>(sqlite3_column_int64(handle_, column));
}

void Statement::get(int column, bool& value) const {
  const std::int64_t number = sqlite3_column_int64(handle_, column);
  if (number != 0 && number != 1) {
    database_.fail("the record is damaged: a flag is neither 0 nor 1");
  }
  value = number == 1;
}

void Statement::get(int column, Verdict& value) const {
  const std::int64_t number = sqlite3_column_int64(handle_, column);
  if (number < 0 || number > static_cast<std::int64_t>(Verdict::kError)) {
    database_.fail("the record is damaged: unknown verdict");
  }
  value = static_cast<Verdict>(number);
}

void Statement::get(int column, double& value) const {
  value = sqlite3_column_type(handle_, column) == SQLITE_NULL
              ? std::numeric_limits<double>::quiet_NaN()
              : sqlite3_column_double(handle_, column);
}

// SQLite requires this order, pointer before size: the first call may convert the value.
void Statement::get(int column, std::string& value) const {
  const unsigned char* data = sqlite3_column_text(handle_, column);
  const int size = sqlite3_column_bytes(handle_, column);
  value.assign(reinterpret_cast<const char*>(data), static_cast<std::size_t>(data ? size : 0));
}

void Statement::get(int column, std::vector<std::uint8_t>& value) const {
  const auto* data = static_cast<const std::uint8_t*>(sqlite3_column_blob(handle_, column));
  const int size = sqlite3_column_bytes(handle_, column);
  value.clear();
  if (data != nullptr) {
    value.assign(data, data + size);
  }
}

}  // namespace gsbench::record
