// The target of `-o`: a file, written completely or not at all, or standard output for "-".
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <render/file.hpp>

namespace gsbench::cli {

class OutputFile {
 public:
  // Throws profile::ConfigurationError if `path` is the same file as one of `inputs`, even under a
  // different name. Throws render::WriteError if it cannot be written.
  OutputFile(const std::string& path, const std::vector<std::string>& inputs);

  bool is_standard_output() const { return file_ == nullptr; }
  void append(std::string_view text);  // throws render::WriteError
  void commit();                       // throws render::WriteError

 private:
  std::unique_ptr<render::File> file_;
};

}  // namespace gsbench::cli
