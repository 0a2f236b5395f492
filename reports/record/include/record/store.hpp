// Stores a run in one SQLite file (WAL), with traces as compressed columns.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::record {

// The store cannot be written or read. what() is "FILE: cause" (disk full, not writable, not a
// record, of a newer version).
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Writes a run while it proceeds. Each call is one transaction: a crash loses the current call
// only. A run without finish() reads back with the fault "the run did not finish" and verdict
// ERROR. After destruction the record is one plain file, without -wal or -shm files. Call begin(),
// then add_outlet() for each outlet, then finish(). Another order throws std::logic_error. Columns
// of unequal length throw std::invalid_argument. A failure of the file throws StoreError. Earlier
// calls remain stored after any error. Not thread-safe.
class Writer {
 public:
  // Creates the file. Throws StoreError if it exists or cannot be written.
  explicit Writer(const std::string& path);
  ~Writer();

  void begin(const RunRecord& head);            // without outlets and final verdict
  void add_outlet(const OutletRecord& outlet);  // with its traces and results
  void finish(const RunRecord& whole);  // with verdict, time stamps, comparisons and reference

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Throws StoreError if the file is not a record, is of another version, or was changed. A stored
// digest of every part detects changes.
RunRecord read_run(const std::string& path);

// The same without the outlets, which are most of the file.
RunRecord read_head(const std::string& path);

// SHA-256 (hexadecimal) of a record without run id and wall-clock times: equal for equal profile,
// seed and build.
std::string content_digest(const RunRecord& run);

}  // namespace gsbench::record
