// The files of a record that is about to be written.
#pragma once

#include <string>

namespace gsbench::record {

// Creates an empty record. A process that is killed leaves no file, an empty one, or a record.
// Throws StoreError if the file exists or cannot be created.
void create_record(const std::string& path);

// The file beside a record.
std::string reserve_of(const std::string& path);

// Creates the reserve of a record: on a full disk, its removal makes room for the reason why the
// run ended. It is locked, so that others know that the record is being written. Throws StoreError.
class Reserve {
 public:
  explicit Reserve(const std::string& record);
  ~Reserve() { free(); }
  Reserve(const Reserve&) = delete;
  Reserve& operator=(const Reserve&) = delete;

  void free() noexcept;

 private:
  std::string path_;
  int file_ = -1;  // -1: it is free
};

}  // namespace gsbench::record
