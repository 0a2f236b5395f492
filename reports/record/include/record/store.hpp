// Stores a run while it proceeds, and reads it back.
#pragma once

#include <cstddef>
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

// Takes a run while it proceeds: begin(), add_outlet() for each outlet, append() as its reports
// arrive, update_outlet() with its results, finish(). Another order throws std::logic_error.
// Columns of unequal length throw std::invalid_argument. Not thread-safe.
class Store {
 public:
  virtual ~Store() = default;
  virtual void begin(const RunRecord& head) = 0;            // without outlets and final verdict
  virtual void add_outlet(const OutletRecord& outlet) = 0;  // with the reports that it has
  // Element i: what has arrived from the i-th outlet since the last call.
  virtual void append(const std::vector<Reports>& reports) = 0;
  // Replaces all but the settings and the reports.
  virtual void update_outlet(std::size_t i, const OutletRecord& outlet) = 0;
  // The i-th outlet without its traces, which may be too long for the memory. read_reports() gives
  // them, in pieces. Neither is placed on the run's time.
  virtual OutletRecord outlet(std::size_t i) = 0;
  virtual void read_reports(std::size_t i, const TakeReports& take) = 0;
  // With verdict, time stamps, comparisons and reference; its outlets are not used.
  virtual void finish(const RunRecord& head) = 0;
  // In place of finish(), if a call failed: notes the fault in `head` if that is possible.
  virtual void abandon(const RunRecord& head) noexcept = 0;
};

// In memory.
class MemoryStore final : public Store {
 public:
  void begin(const RunRecord&) override {}
  void add_outlet(const OutletRecord& outlet) override { outlets_.push_back(outlet); }
  void append(const std::vector<Reports>& reports) override;
  void update_outlet(std::size_t i, const OutletRecord& outlet) override;
  OutletRecord outlet(std::size_t i) override;
  void read_reports(std::size_t i, const TakeReports& take) override {
    take(outlets_.at(i).reports);
  }
  void finish(const RunRecord&) override {}
  void abandon(const RunRecord&) noexcept override {}

 private:
  std::vector<OutletRecord> outlets_;
};

// In one SQLite file (WAL), with traces as compressed columns. Each call is one transaction: a
// crash of the process loses the current call only, a power cut those of the last seconds. A run
// without finish() reads back as interrupted, with verdict ERROR. Until destruction, FILE-wal,
// FILE-shm and FILE-reserve, which has no content, belong to it; after a crash, the first reader
// that can write the folder makes one plain file of them. A failure of the file throws StoreError;
// earlier calls remain stored. After begin(), its message has the file's name without the folder.
class Writer final : public Store {
 public:
  // Creates the file. Throws StoreError if it exists or cannot be written.
  explicit Writer(const std::string& path);
  ~Writer() override;

  void begin(const RunRecord& head) override;
  void add_outlet(const OutletRecord& outlet) override;
  void append(const std::vector<Reports>& reports) override;
  void update_outlet(std::size_t i, const OutletRecord& outlet) override;
  OutletRecord outlet(std::size_t i) override;
  void read_reports(std::size_t i, const TakeReports& take) override;
  void finish(const RunRecord& head) override;
  void abandon(const RunRecord& head) noexcept override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// True while a Writer of any process has the record open. Call it before the record is read.
bool is_in_progress(const std::string& path);

// Reads a record outlet by outlet. Of a run that is still written, it sees the state at its
// construction. All calls throw StoreError if the file is not a record, is of an unknown version,
// or if what they read was changed: a stored digest of every part detects changes. marked() alone
// does not compare those of marks; read_reports() does.
class Reader {
 public:
  explicit Reader(const std::string& path);
  ~Reader();

  const RunRecord& head() const;  // without outlets
  std::size_t outlets() const;
  // The i-th outlet without its reports; with its marks and what it was sent; with all. Reports are
  // placed on the run's time. Of a run that was not judged to its end, it has no measurements.
  OutletRecord results(std::size_t i);
  OutletRecord marked(std::size_t i);
  OutletRecord outlet(std::size_t i);
  // Reads all reports, and so finds changes also in those that are not asked for.
  void check();
  // The reports of the i-th outlet in pieces, so that a run of any length can be read.
  void read_reports(std::size_t i, const TakeReports& take);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// The whole record.
RunRecord read_run(const std::string& path);

// The same without the reports of any outlet. Records of version 6 keep some marks.
RunRecord read_results(Reader& reader);

// The same without the outlets, which are most of the file.
RunRecord read_head(const std::string& path);

// SHA-256 (hexadecimal) of a record without run id, wall-clock times and the software around it:
// equal for equal profile, seed and build.
std::string content_digest(const RunRecord& run);

// The same, outlet by outlet: all pieces of its reports, then its results.
class ContentDigest {
 public:
  ContentDigest();
  ~ContentDigest();

  void add_traces(const Reports& piece);        // only its traces
  void add_outlet(const OutletRecord& outlet);  // without its traces
  std::string of(const RunRecord& head);        // then once

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gsbench::record
