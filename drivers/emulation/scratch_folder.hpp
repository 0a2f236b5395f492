// The folder of an emulated station's files, locked by its owner for as long as that lives: what a
// bench that was killed has left behind is distinguished by that, and removed by the next.
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
  ~ScratchFolder();  // with all that is in it

  const std::string& path() const { return path_; }

 private:
  ScratchFolder() = default;

  std::string path_;
  drivers::Descriptor lock_;
};

}  // namespace gsbench::emulation
