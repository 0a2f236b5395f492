// Keeps a run in one SQLite file (WAL), traces as compressed columns.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::record {

// The store cannot be written or read: what() names the file and the cause (disk full, not
// writable, not a record, of a newer version).
class StoreError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Writes one run as it goes: each call is one transaction, so that a crash loses the call in hand
// and nothing before it. A run that was begun and never finished reads back with the fault
// "the run did not finish" and verdict ERROR. Once closed the record is one plain file, with no
// -wal or -shm beside it. begin comes first, then the outlets, then finish: another order is
// std::logic_error; columns of unequal length are std::invalid_argument. After any error what was
// written before still stands.
class Writer {
 public:
  // Creates the file; refuses (StoreError) where it exists or cannot be written.
  explicit Writer(const std::string& path);
  ~Writer();

  void begin(const RunRecord& head);            // everything but outlets' results and verdict
  void add_outlet(const OutletRecord& outlet);  // with traces and results
  void finish(const RunRecord& whole);          // verdict, stamps, comparisons, reference

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Throws StoreError where the file is no record, of another version, or not what was written: every
// part is sealed with a digest when it is written.
RunRecord read_run(const std::string& path);

// The same without the outlets, which are by far the most of it.
RunRecord read_head(const std::string& path);

// Digest (SHA-256, hexadecimal) over all of a record but run id and wall-clock stamps: equal for
// equal profile, seed and build.
std::string content_digest(const RunRecord& run);

}  // namespace gsbench::record
