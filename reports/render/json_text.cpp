#include "json_text.hpp"

#include <fmt/format.h>

namespace gsbench::render {

std::string indented(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string indented(const Json& json, std::size_t spaces) {
  const std::string margin(spaces, ' ');
  std::string text = margin;
  for (const char character : json.dump(2, ' ', false, Json::error_handler_t::replace)) {
    text += character;
    if (character == '\n') {  // between values only: in texts it is escaped
      text += margin;
    }
  }
  return text;
}

std::string in_script(const Json& json) {
  std::string safe;
  for (const char character : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    if (character == '<' || character == '>' || character == '&') {
      safe += fmt::format("\\u{:04x}", static_cast<unsigned char>(character));
    } else {
      safe += character;
    }
  }
  return safe;
}

}  // namespace gsbench::render
