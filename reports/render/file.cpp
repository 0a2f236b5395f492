#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include <render/file.hpp>

namespace gsbench::render {

namespace fs = std::filesystem;

struct File::Impl {
  explicit Impl(std::string the_path) : path(std::move(the_path)) {}

  ~Impl() {
    if (descriptor >= 0) {
      ::close(descriptor);
      ::unlink(temporary.c_str());
    }
  }

  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[noreturn]] void refuse(const std::string& cause) const {
    throw WriteError(path + ": cannot be written: " + cause);
  }
  [[noreturn]] void refuse(int error) const { refuse(std::generic_category().message(error)); }

  // The mode of a new file is that of the user's umask; that of a file that is replaced stays.
  void open() {
    constexpr mode_t kNew = 0666;
    constexpr mode_t kPermissions = 07777;
    struct stat there {};
    const bool exists = ::stat(path.c_str(), &there) == 0;
    if (exists && !S_ISREG(there.st_mode)) {
      // The rename would replace a device, such as /dev/null, by a file.
      refuse(S_ISDIR(there.st_mode) ? "it is a directory"
                                    : "it is a device or pipe, not an ordinary file");
    }
    if (exists && ::access(path.c_str(), W_OK) != 0) {
      refuse(errno);
    }
    std::error_code error;
    target = exists ? fs::canonical(path, error).string() : path;  // a link stays a link
    const std::string name = ".gsbench-" + std::to_string(::getpid()) + "-";
    for (int n = 0; descriptor < 0; ++n) {
      temporary = fs::path(target).parent_path() / (name + std::to_string(n));
      descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kNew);
      if (descriptor < 0 && errno != EEXIST) {
        refuse(errno);
      }
    }
    if (exists) {
      ::fchmod(descriptor, there.st_mode & kPermissions);
    }
  }

  std::string path;       // as given
  std::string target;     // the file that is replaced
  std::string temporary;  // in the same folder
  int descriptor = -1;    // of the temporary file; -1 after the commit
};

File::File(const std::string& path) : impl_(std::make_unique<Impl>(path)) {
  impl_->open();
}

File::~File() = default;

void File::append(std::string_view text) {
  // On a full disk write() takes a part; the error appears when the rest is written.
  while (!text.empty()) {
    const ssize_t taken = ::write(impl_->descriptor, text.data(), text.size());
    if (taken < 0 && errno == EINTR) {
      continue;
    }
    if (taken < 0) {
      impl_->refuse(errno);
    }
    text.remove_prefix(static_cast<std::size_t>(taken));
  }
}

void File::commit() {
  // Otherwise a power cut after the rename could leave an empty file in place of the old one.
  // EINVAL: this file system has nothing to flush.
  if (::fsync(impl_->descriptor) != 0 && errno != EINVAL) {
    impl_->refuse(errno);
  }
  if (::rename(impl_->temporary.c_str(), impl_->target.c_str()) != 0) {
    impl_->refuse(errno);
  }
  ::close(std::exchange(impl_->descriptor, -1));
}

void write_file(const std::string& path, const std::string& content) {
  File file(path);
  file.append(content);
  file.commit();
}

}  // namespace gsbench::render
