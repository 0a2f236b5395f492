#include "commands.hpp"

#include <cmath>
#include <cstdio>
#include <string>

#include <nlohmann/json.hpp>

#include <keys/key.hpp>
#include <profile/load.hpp>
#include <station/instrument_file.hpp>
#include <station/station_file.hpp>

namespace gsbench::cli {
namespace {

using nlohmann::ordered_json;

ordered_json schema_of(const keys::Key& key);

void add_range(const keys::Range& range, ordered_json& schema) {
  if (std::isfinite(range.low)) {
    schema[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  }
  if (std::isfinite(range.high)) {
    schema[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
  }
}

ordered_json object(const keys::Key& table) {
  ordered_json schema = {{"type", "object"},
                         {"properties", ordered_json::object()},
                         {"required", ordered_json::array()},
                         {"additionalProperties", false}};
  for (const keys::Key& key : table.inner) {
    schema["properties"][key.name] = schema_of(key);
    if (key.required) {
      schema["required"].push_back(key.name);
    }
  }
  return schema;
}

ordered_json array_of(ordered_json items) {
  return {{"type", "array"}, {"items", std::move(items)}, {"minItems", 1}};
}

ordered_json row_of(const keys::Key& row) {
  ordered_json columns = ordered_json::array();
  for (const keys::Key& column : row.inner) {
    columns.push_back(schema_of(column));
  }
  const std::size_t count = columns.size();
  return {
      {"type", "array"}, {"items", std::move(columns)}, {"minItems", count}, {"maxItems", count}};
}

ordered_json shape_of(const keys::Key& key) {
  switch (key.type) {
    case keys::Type::kNumber:
      return {{"type", "number"}};
    case keys::Type::kWhole:
      return {{"type", "integer"}};
    case keys::Type::kText:
      return {{"type", "string"}, {"minLength", 1}};
    case keys::Type::kTextOrWhole:
    case keys::Type::kInstant: {
      ordered_json number = {{"type", key.type == keys::Type::kInstant ? "number" : "integer"}};
      add_range(key.range, number);
      return {{"anyOf", {{{"type", "string"}, {"minLength", 1}}, std::move(number)}}};
    }
    case keys::Type::kId:
      return {{"type", "string"},
              {"minLength", 1},
              {"maxLength", key.longest},
              {"pattern", "^[A-Za-z0-9_.-]+$"}};
    case keys::Type::kChoice:
      return {{"type", "string"}, {"enum", key.choices}};
    case keys::Type::kArray:
      return array_of(schema_of(key.inner.front()));
    case keys::Type::kRow:
      return row_of(key);
    case keys::Type::kTable:
      return object(key);
    case keys::Type::kTables:
      return array_of(object(key));
    case keys::Type::kTextOrTable:
      return {{"anyOf", {{{"type", "string"}, {"minLength", 1}}, object(key)}}};
  }
  return {};
}

std::string description_of(const keys::Key& key) {
  std::string text = key.meaning;
  const auto add = [&](const char* what, const std::string& value) {
    if (!value.empty()) {
      text += (text.empty() ? "" : "; ") + (what + value);
    }
  };
  add("unit: ", key.unit);
  add("range: ", key.permitted);
  add("default: ", key.otherwise);
  return text;
}

ordered_json schema_of(const keys::Key& key) {
  ordered_json schema = shape_of(key);
  if (keys::is_number(key)) {
    add_range(key.range, schema);
  }
  if (const auto* number = std::get_if<double>(&key.fallback)) {
    schema["default"] = *number;
  }
  if (const auto* text = std::get_if<std::string>(&key.fallback)) {
    schema["default"] = *text;
  }
  const std::string description = description_of(key);
  if (!description.empty()) {
    schema["description"] = description;
  }
  return schema;
}

constexpr const char* kDraft = "http://json-schema.org/draft-07/schema#";

ordered_json json_schema(const keys::Key& format) {
  ordered_json schema = {{"$schema", kDraft}, {"title", format.name}};
  schema.update(object(format));
  return schema;
}

// The keys of a station depend on its kind.
ordered_json station_schema() {
  ordered_json schema = {
      {"$schema", kDraft}, {"title", "a station"}, {"oneOf", ordered_json::array()}};
  for (const std::string& kind : station::station_kind_names()) {
    schema["oneOf"].push_back(object(station::station_keys(kind)));
  }
  return schema;
}

std::string station_markdown() {
  std::string text;
  for (const std::string& kind : station::station_kind_names()) {
    text += (text.empty() ? "" : "\n") + ("Keys of a station of kind `" + kind + "`:\n\n") +
            keys::markdown(station::station_keys(kind));
  }
  return text;
}

struct SchemaArguments {
  std::string format;
  bool markdown = false;
};

int schema(const SchemaArguments& arguments) {
  if (arguments.format == "station") {
    if (arguments.markdown) {
      std::fputs(station_markdown().c_str(), stdout);
    } else {
      print_json_document(station_schema());
    }
    return kPassed;
  }
  const keys::Key& keys = arguments.format == "profile" ? profile::profile_keys()
                          : arguments.format == "grid"  ? profile::grid_keys()
                                                        : station::instrument_keys();
  if (arguments.markdown) {
    std::fputs(keys::markdown(keys).c_str(), stdout);
  } else {
    print_json_document(json_schema(keys));
  }
  return kPassed;
}

}  // namespace

void add_schema(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "schema", "Print the JSON Schema of a file format, for editors and other tools", schema);
  command
      .add_option("FORMAT", arguments.format, "File format: profile, grid, station or instrument")
      ->type_name("FORMAT")
      ->required()
      ->check(CLI::IsMember({"profile", "grid", "station", "instrument"}));
  command.add_flag("--markdown", arguments.markdown,
                   "Print the tables of keys of the Markdown files in profiles and drivers");
  command.footer("Example:\n  gsbench schema profile > profile.schema.json");
}

}  // namespace gsbench::cli
