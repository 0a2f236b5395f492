// Files that are written completely or not at all: a temporary file in the same folder replaces the
// named file on commit().
#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gsbench::render {

// what() is "PATH: cannot be written: cause".
class WriteError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class File {
 public:
  // Throws WriteError if the file cannot be written, or is a directory, device or pipe.
  explicit File(const std::string& path);
  // Without commit() an existing file is unchanged, and no other file is left.
  ~File();
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void append(std::string_view text);  // throws WriteError
  void commit();                       // throws WriteError

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Throws WriteError.
void write_file(const std::string& path, const std::string& content);

}  // namespace gsbench::render
