// What all JSON texts of reports have in common.
#pragma once

#include <cmath>
#include <string>

#include <nlohmann/json.hpp>

namespace gsbench::render {

using Json = nlohmann::ordered_json;

// null for what is no finite number.
inline Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

// Indented by two, with a newline at its end. Bytes that are no UTF-8 become U+FFFD here as below.
std::string indented(const Json& json);

// JSON that may stand inside <script>, where an HTML parser knows no entities: no "<", ">" or "&"
// occurs in it.
std::string in_script(const Json& json);

}  // namespace gsbench::render
