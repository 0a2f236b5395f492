// What all JSON texts of reports have in common.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gsbench::render {

using Json = nlohmann::ordered_json;

// What `each` makes of every part.
template <class Part, class Each>
Json array_of(const std::vector<Part>& parts, const Each& each) {
  Json all = Json::array();
  for (const Part& part : parts) {
    all.push_back(each(part));
  }
  return all;
}

// Indented by two, with a newline at its end. Here as below, a number that is not finite becomes
// null, and bytes that are no UTF-8 U+FFFD.
std::string indented(const Json& json);

// JSON that may stand inside <script>, where an HTML parser knows no entities: no "<", ">" or "&"
// occurs in it.
std::string in_script(const Json& json);

}  // namespace gsbench::render
