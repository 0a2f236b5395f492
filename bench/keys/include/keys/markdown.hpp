// Declared keys as the tables of profiles/README.md.
#pragma once

#include <string>

#include <keys/key.hpp>

namespace gsbench::keys {

// A table of the keys, then a section for each table within, in the order of declaration.
std::string markdown(const Key& format);

}  // namespace gsbench::keys
