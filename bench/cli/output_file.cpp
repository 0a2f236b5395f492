#include "output_file.hpp"

#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::cli {

OutputFile::OutputFile(const std::string& path, const std::vector<std::string>& inputs) {
  if (path == "-") {
    return;
  }
  for (const std::string& input : inputs) {
    std::error_code ignored;  // a path that does not exist is not an input
    if (!input.empty() && std::filesystem::equivalent(path, input, ignored)) {
      throw profile::ConfigurationError(fmt::format(
          "{}: cannot be written, as it is the input {}; name another file", path, input));
    }
  }
  file_ = std::make_unique<render::File>(path);
}

void OutputFile::append(std::string_view text) {
  if (file_ != nullptr) {
    file_->append(text);
  } else if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size()) {
    throw render::WriteError("standard output cannot be written");
  }
}

void OutputFile::commit() {
  if (file_ != nullptr) {
    file_->commit();
  } else if (std::fflush(stdout) != 0) {
    throw render::WriteError("standard output cannot be written");
  }
}

}  // namespace gsbench::cli
