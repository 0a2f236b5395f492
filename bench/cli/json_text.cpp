#include "json_text.hpp"

#include <nlohmann/json.hpp>

namespace gsbench::cli {

std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(2) + '\n';
}

}  // namespace gsbench::cli
