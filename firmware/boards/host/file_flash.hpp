// The flash of an outlet without a bench: a file, so that settings outlive the process. The file
// has the layout of the terminals, with magic and flash alone. What it does not have yet is erased.
#pragma once

#include <settings_storage/settings_storage.hpp>

#include <string>

namespace gs::host {

class FileFlash final : public settings_storage::Flash {
 public:
  FileFlash() = default;
  ~FileFlash();
  FileFlash(const FileFlash&) = delete;
  FileFlash& operator=(const FileFlash&) = delete;

  // Makes the file if it does not exist, and locks it. Returns false with the reason in `why` if it
  // cannot be opened for reading and writing, is of another kind, or is used by another process.
  // Without open(), all is erased and nothing can be written.
  bool open(const std::string& path, std::string& why);

  // False if the file takes nothing more, for instance because the disk is full, or if it has been
  // deleted: it would not be found at the next start.
  bool erase(int slot) override;
  bool program(int slot, std::size_t offset, std::uint32_t word) override;
  std::uint32_t read(int slot, std::size_t offset) const override;

 private:
  int file_ = -1;
};

}  // namespace gs::host
