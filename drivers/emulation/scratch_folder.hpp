// The folder of a desk's files, locked by its owner for as long as that lives: what a bench that
// was killed has left behind is told from what is in use, and removed by the next.
#pragma once

#include "descriptor.hpp"

#include <string>

#include <drivers/result.hpp>

namespace gsbench::emulation {

class ScratchFolder {
 public:
  static drivers::Result<ScratchFolder> create();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&& other) noexcept = delete;
  ~ScratchFolder();  // with all that is in it

  const std::string& path() const { return path_; }

 private:
  ScratchFolder() = default;

  std::string path_;
  Descriptor lock_;
};

}  // namespace gsbench::emulation
