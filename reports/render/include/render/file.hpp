// Files that are written whole or not at all: a temporary file beside the named one takes its place
// on commit().
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gsbench::render {

// Names path and cause.
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class File {
 public:
  // Throws WriteError where no file can be written; a device or pipe is no place for one.
  explicit File(const std::string& path);
  // Without commit() nothing is left, and what had been there is there still.
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void append(std::string_view text);  // throws WriteError
  void commit();                       // throws WriteError

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

void write_file(const std::string& path, const std::string& content);

}  // namespace gsbench::render
