// The file with the password for a broker.
#pragma once

#include <string>

namespace gs::host {

// The first line of a file, without a byte order mark at its beginning and a carriage return at its
// end. Returns false with the reason in `why` if the file cannot be read or the line is empty.
bool read_password(const std::string& file, std::string& password, std::string& why);

}  // namespace gs::host
