// Functions that all JSON reports share.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gsbench::render {

using Json = nlohmann::ordered_json;

// The results of `each` for every part.
template <class Part, class Each>
Json array_of(const std::vector<Part>& parts, const Each& each) {
  Json all = Json::array();
  for (const Part& part : parts) {
    all.push_back(each(part));
  }
  return all;
}

// Indented by two, with a line end. Here and below, numbers that are not finite become null, and
// bytes that are not UTF-8 become U+FFFD.
std::string indented(const Json& json);
// The same inside of other JSON: all lines begin with `spaces` more; without a line end.
std::string indented(const Json& json, std::size_t spaces);

// JSON for a <script> element, in which HTML entities are not decoded: "<", ">" and "&" are written
// as \u escapes.
std::string in_script(const Json& json);

}  // namespace gsbench::render
