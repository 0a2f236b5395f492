// The folder of an emulated station's files. Its owner holds a lock on it. A folder without a lock
// is left over from a killed bench; the next create() removes it.
#pragma once

#include <memory>
#include <string>

#include <drivers/descriptor.hpp>
#include <drivers/result.hpp>

namespace gsbench::emulation {

class ScratchFolder {
 public:
  static drivers::Result<std::unique_ptr<ScratchFolder>> create();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();  // removes the folder and its files

  const std::string& path() const { return path_; }

 private:
  ScratchFolder() = default;

  std::string path_;
  drivers::Descriptor lock_;
};

}  // namespace gsbench::emulation
