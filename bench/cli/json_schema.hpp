// Declared keys as a JSON Schema, for editors that check TOML against one.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <keys/key.hpp>

namespace gsbench::cli {

// Of draft 7, which editors' TOML extensions know.
nlohmann::ordered_json json_schema(const keys::Key& format);

}  // namespace gsbench::cli
