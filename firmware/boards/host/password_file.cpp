#include "password_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>

namespace gs::host {

bool read_password(const std::string& file, std::string& password, std::string& why) {
  const std::string mark = "\xEF\xBB\xBF";
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  if (!std::getline(stream, password) && errno != 0) {
    why = file + ": cannot be read: " + std::strerror(errno);
    return false;
  }
  if (password.compare(0, mark.size(), mark) == 0) {
    password.erase(0, mark.size());
  }
  if (!password.empty() && password.back() == '\r') {
    password.pop_back();
  }
  if (password.empty() || password.find('\0') != std::string::npos) {
    why = file + ": its first line must be the password, as UTF-8 text";
    return false;
  }
  constexpr std::size_t kLongest = 65535;  // of a string in MQTT
  if (password.size() > kLongest) {
    why = file + ": its first line has " + std::to_string(password.size()) +
          " bytes; a password has at most 65535";
    return false;
  }
  return true;
}

}  // namespace gs::host
