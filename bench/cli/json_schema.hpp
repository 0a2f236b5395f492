// Declared keys as a JSON Schema, for editors that check TOML against one.
#pragma once

#include <string>

#include <keys/key.hpp>

namespace gsbench::cli {

// Of draft 7, which editors' TOML extensions know.
std::string json_schema(const keys::Key& format);

}  // namespace gsbench::cli
