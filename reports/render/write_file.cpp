#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QString>

#include <render/render.hpp>

namespace gsbench::render {

void write_file(const std::string& path, const std::string& content) {
  const QFileInfo there(QFile::decodeName(path.c_str()));
  if (there.exists() && !there.isFile()) {
    // The rename would put a file in the place of a device, to the harm of everyone else.
    throw WriteError(path + ": cannot be written: it is " +
                     (there.isDir() ? "a directory" : "a device or pipe, no ordinary file"));
  }
  QSaveFile file(QFile::decodeName(path.c_str()));
  const auto refuse = [&] {
    throw WriteError(path + ": cannot be written: " + file.errorString().toStdString());
  };
  if (!file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) refuse();
  // A disk that fills up takes a part without complaint, and commit() would keep just that part:
  // only writing the rest tells the error.
  qint64 written = 0;
  while (written < static_cast<qint64>(content.size())) {
    const qint64 taken =
        file.write(content.data() + written, static_cast<qint64>(content.size()) - written);
    if (taken <= 0) refuse();
    written += taken;
  }
  if (!file.commit()) refuse();
}

}  // namespace gsbench::render
