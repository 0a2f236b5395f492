// RAII for SQLite's C interface. Every failure throws StoreError with the file and the cause.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include <record/run_record.hpp>

struct sqlite3;
struct sqlite3_stmt;

namespace gsbench::record {

class Statement;

class Database {
 public:
  enum class Mode { kRead, kWrite };

  // The file must exist. `path` is always a file path, never a URI or ":memory:". What a killed
  // process has left beside the file (-wal, -journal) becomes part of it, and its -reserve is
  // removed, if the folder can be written.
  Database(const std::string& path, Mode mode);
  static Database in_memory();
  ~Database();
  Database(Database&& other) noexcept;
  Database& operator=(Database&&) = delete;

  void execute(const std::string& sql);
  Statement prepare(const std::string& sql);
  template <class Value>
  Value first(const std::string& sql);  // first column of the first row
  // Runs `work` in one transaction. If `work` throws, the transaction is rolled back.
  void transact(const std::function<void()>& work);

  std::vector<std::uint8_t> bytes() const;  // as in a file

  // The name of the file in messages from now on, in place of its path.
  void show_as(const std::string& name) { path_ = name; }
  [[noreturn]] void fail(const std::string& cause) const;  // "path: cause"
  [[noreturn]] void fail_with(int code) const;

 private:
  Database() = default;

  std::string path_;
  sqlite3* handle_ = nullptr;
};

class Statement {
 public:
  Statement(const Database& database, sqlite3_stmt* handle);
  ~Statement();
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  bool step();  // true if there is a row
  void reset();

  // Parameters count from 1. A NaN is stored as NULL.
  void bind(int parameter, double value);
  void bind(int parameter, const std::string& value);
  void bind(int parameter, const std::vector<std::uint8_t>& value);
  template <class Whole>
  void bind(int parameter, Whole value) {
    static_assert(std::is_integral_v<Whole> || std::is_enum_v<Whole>);
    bind_integer(parameter, static_cast<std::int64_t>(value));  // unsigned values keep their bits
  }

  // Columns count from 0. Throws StoreError for a value out of range.
  void get(int column, std::int64_t& value) const;
  void get(int column, std::uint64_t& value) const;
  void get(int column, bool& value) const;
  void get(int column, Verdict& value) const;
  void get(int column, double& value) const;
  void get(int column, std::string& value) const;
  void get(int column, std::vector<std::uint8_t>& value) const;

 private:
  void check(int code) const;
  void bind_integer(int parameter, std::int64_t value);

  const Database& database_;
  sqlite3_stmt* handle_;
};

template <class Value>
Value Database::first(const std::string& sql) {
  Statement statement = prepare(sql);
  Value value{};
  if (statement.step()) {
    statement.get(0, value);
  }
  return value;
}

}  // namespace gsbench::record
