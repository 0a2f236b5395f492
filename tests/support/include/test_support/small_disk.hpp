// A tmpfs of limited size, mounted on a folder until the end of the scope. mounted() is false if
// the test may not mount.
#pragma once

#include <sys/mount.h>

#include <filesystem>

namespace gsbench::test {

class SmallDisk {
 public:
  // `size`: "size=32k", an option of tmpfs.
  SmallDisk(const std::filesystem::path& folder, const char* size)
      : folder_(folder), mounted_(::mount("tmpfs", folder_.c_str(), "tmpfs", 0, size) == 0) {}
  ~SmallDisk() {
    if (mounted_) {
      ::umount2(folder_.c_str(), MNT_DETACH);
    }
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  bool mounted() const { return mounted_; }

 private:
  std::filesystem::path folder_;
  bool mounted_;
};

}  // namespace gsbench::test
