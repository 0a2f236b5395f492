// Where `-o` leads: a file, written whole or not at all, or with "-" standard output.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <render/file.hpp>

namespace gsbench::cli {

class OutputFile {
 public:
  // Throws profile::ConfigurationError where `path` is one of `inputs`, under whatever name, and
  // render::WriteError where it cannot be written.
  OutputFile(const std::string& path, const std::vector<std::string>& inputs);

  bool is_standard_output() const { return file_ == nullptr; }
  void append(std::string_view text);  // throws render::WriteError
  void commit();                       // throws render::WriteError

 private:
  std::unique_ptr<render::File> file_;
};

}  // namespace gsbench::cli
