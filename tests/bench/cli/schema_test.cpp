// The JSON Schema for editors: every shipped file is valid, and files with mistakes are not.
#include "gsbench_process.hpp"

#include <algorithm>
#include <filesystem>
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <keys/document.hpp>

namespace gsbench::test {
namespace {

namespace fs = std::filesystem;

struct ToJson {
  json operator()(const keys::DateOrTime& value) const { return value.text; }
  json operator()(const keys::Array& items) const {
    json out = json::array();
    for (const auto& item : items) {
      out.push_back(std::visit(*this, item.data));
    }
    return out;
  }
  json operator()(const keys::Entries& entries) const {
    json out = json::object();
    for (const auto& entry : entries) {
      out[entry.key] = std::visit(*this, entry.value.data);
    }
    return out;
  }
  template <typename Plain>
  json operator()(const Plain& value) const {
    return value;
  }
};

bool has_type(const json& value, const std::string& type) {
  return type == "integer" ? value.is_number_integer() : value.type_name() == type;
}

// The first invalid place; empty if the value is valid. Only the keywords of JSON Schema that our
// schemas use; throws std::logic_error for others.
std::string invalid_at(const json& value, const json& schema, const std::string& path) {
  const std::size_t size = value.is_string() ? value.get<std::string>().size() : value.size();
  for (const auto& [keyword, asked] : schema.items()) {
    bool holds = true;
    if (keyword == "type") {
      holds = has_type(value, asked);
    } else if (keyword == "enum") {
      holds = std::find(asked.begin(), asked.end(), value) != asked.end();
    } else if (keyword == "minimum") {
      holds = !value.is_number() || value >= asked;
    } else if (keyword == "maximum") {
      holds = !value.is_number() || value <= asked;
    } else if (keyword == "exclusiveMinimum") {
      holds = !value.is_number() || value > asked;
    } else if (keyword == "exclusiveMaximum") {
      holds = !value.is_number() || value < asked;
    } else if (keyword == "minItems" || keyword == "minLength") {
      holds = size >= asked;
    } else if (keyword == "maxItems" || keyword == "maxLength") {
      holds = size <= asked;
    } else if (keyword == "pattern") {
      holds = value.is_string() &&
              std::regex_search(value.get<std::string>(), std::regex(asked.get<std::string>()));
    } else if (keyword == "anyOf") {
      holds = std::any_of(asked.begin(), asked.end(), [&](const json& choice) {
        return invalid_at(value, choice, path).empty();
      });
    } else if (keyword == "oneOf") {
      // The alternatives differ in `kind`.
      const auto chosen = std::find_if(asked.begin(), asked.end(), [&](const json& choice) {
        return invalid_at(value["kind"], choice["properties"]["kind"], "").empty();
      });
      return chosen == asked.end() ? path + ".kind" : invalid_at(value, *chosen, path);
    } else if (keyword == "required") {
      holds = std::all_of(asked.begin(), asked.end(),
                          [&](const json& key) { return value.contains(key); });
    } else if (keyword == "additionalProperties") {
      for (const auto& [key, inner] : value.items()) {
        if (!schema["properties"].contains(key)) {
          return fmt::format("{}.{}", path, key);
        }
      }
    } else if (keyword == "properties") {
      for (const auto& [key, inner] : value.items()) {
        if (!asked.contains(key)) {
          continue;
        }
        std::string where = invalid_at(inner, asked[key], fmt::format("{}.{}", path, key));
        if (!where.empty()) {
          return where;
        }
      }
    } else if (keyword == "items") {
      for (std::size_t i = 0; i < value.size(); ++i) {
        const json& item = asked.is_array() ? asked.at(i) : asked;
        std::string where = invalid_at(value[i], item, fmt::format("{}[{}]", path, i));
        if (!where.empty()) {
          return where;
        }
      }
    } else if (keyword != "description" && keyword != "default" && keyword != "title" &&
               keyword != "$schema") {
      throw std::logic_error("unknown keyword: " + keyword);
    }
    if (!holds) {
      return fmt::format("{} ({})", path, keyword);
    }
  }
  return "";
}

json read(const fs::path& path) {
  return std::visit(ToJson{}, keys::parse_toml(text_of(path), path.string()).root.data);
}

std::string format_of(const fs::path& path) {
  const std::string folder = path.parent_path().filename();
  return folder == "grids"         ? "grid"
         : folder == "stations"    ? "station"
         : folder == "instruments" ? "instrument"
                                   : "profile";
}

TEST(Schema, AcceptsEveryShippedFileAndRejectsUnknownKeys) {
  std::map<std::string, int> seen;
  const std::map<std::string, json> schemas = {
      {"profile", run_for_json({"schema", "profile"})},
      {"grid", run_for_json({"schema", "grid"})},
      {"station", run_for_json({"schema", "station"})},
      {"instrument", run_for_json({"schema", "instrument"})}};
  for (const char* const folder : {"/profiles", "/drivers/source/scpi/instruments"}) {
    for (const auto& entry :
         fs::recursive_directory_iterator(std::string(GSBENCH_SOURCE_DIR) + folder)) {
      if (entry.path().extension() != ".toml") {
        continue;
      }
      const std::string format = format_of(entry.path());
      const json& schema = schemas.at(format);
      json file = read(entry.path());
      EXPECT_EQ(invalid_at(file, schema, ""), "") << entry.path();
      file["titel"] = "misspelt";
      EXPECT_EQ(invalid_at(file, schema, ""), ".titel") << entry.path();
      ++seen[format];
    }
  }
  EXPECT_GT(seen["instrument"], 3);
  EXPECT_GT(seen["profile"], 10);
  EXPECT_GT(seen["grid"], 2);
  EXPECT_GT(seen["station"], 3);
}

TEST(Schema, RejectsWhatTheBenchRejects) {
  const json schema = run_for_json({"schema", "profile"});
  const json good = read(GSBENCH_SOURCE_DIR "/profiles/paper/loss-500mw.toml");
  const auto spoilt = [&](const char* pointer, const json& value) {
    json file = good;
    file[json::json_pointer(pointer)] = value;
    return invalid_at(file, schema, "");
  };
  EXPECT_EQ(spoilt("/signal/noise_pct", 101), ".signal.noise_pct (maximum)");
  EXPECT_EQ(spoilt("/signal/noise_pct", "1 %"), ".signal.noise_pct (type)");
  EXPECT_EQ(spoilt("/signal/sample_rate_hz", 8000.5), ".signal.sample_rate_hz (type)");
  EXPECT_EQ(spoilt("/signal/harmonics", {{2, 1.0}}), ".signal.harmonics[0] (minItems)");
  EXPECT_EQ(spoilt("/signal/duration", 6), ".signal.duration");
  EXPECT_EQ(spoilt("/outlet/0/event_drop_hz", -1), ".outlet[0].event_drop_hz (minimum)");
  EXPECT_EQ(spoilt("/outlet/0/id", "a b"), ".outlet[0].id (pattern)");
  EXPECT_EQ(spoilt("/grid/system", 24), ".grid.system (anyOf)");
  EXPECT_EQ(spoilt("/outlet", json::array()), ".outlet (minItems)");
  json untitled = good;
  untitled.erase("title");
  EXPECT_EQ(invalid_at(untitled, schema, ""), " (required)");
}

}  // namespace
}  // namespace gsbench::test
