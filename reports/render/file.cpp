#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QString>

#include <render/file.hpp>

namespace gsbench::render {

struct File::Impl {
  explicit Impl(const std::string& named) : path(named), file(QFile::decodeName(named.c_str())) {}

  [[noreturn]] void refuse() const {
    throw WriteError(path + ": cannot be written: " + file.errorString().toStdString());
  }

  std::string path;
  QSaveFile file;
};

File::File(const std::string& path) : impl_(std::make_unique<Impl>(path)) {
  const QFileInfo there(impl_->file.fileName());
  if (there.exists() && !there.isFile()) {
    // The rename would replace a device, such as /dev/null, by a file.
    throw WriteError(path + ": cannot be written: it is " +
                     (there.isDir() ? "a directory" : "a device or pipe, not an ordinary file"));
  }
  if (!impl_->file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) {
    impl_->refuse();
  }
}

File::~File() = default;

void File::append(std::string_view text) {
  // On a full disk write() takes a part without an error, and commit() would keep that part. The
  // error appears when the rest is written.
  while (!text.empty()) {
    const qint64 taken = impl_->file.write(text.data(), static_cast<qint64>(text.size()));
    if (taken <= 0) {
      impl_->refuse();
    }
    text.remove_prefix(static_cast<std::size_t>(taken));
  }
}

void File::commit() {
  if (!impl_->file.commit()) {
    impl_->refuse();
  }
}

void write_file(const std::string& path, const std::string& content) {
  File file(path);
  file.append(content);
  file.commit();
}

}  // namespace gsbench::render
