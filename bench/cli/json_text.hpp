#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace gsbench::cli {

// Indented, with a newline at its end. Compiled once: nlohmann's writer takes a second a file.
std::string json_text(const nlohmann::ordered_json& value);

}  // namespace gsbench::cli
