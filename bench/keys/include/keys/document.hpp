// A TOML file as plain values, each with its place in the file. Only document.cpp knows the TOML
// library.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include <keys/error.hpp>

namespace gsbench::keys {

struct Position {
  int line = 1;
  int column = 1;
};

struct Entry;
struct Value;
using Array = std::vector<Value>;
using Entries = std::vector<Entry>;  // of a table, in the order of the file
struct DateOrTime {};                // none of our keys is one: all that matters is that it is

struct Value {
  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Entries> data;
  Position at;
};

struct Entry {
  std::string key;
  Position at;
  Value value;
};

struct Document {
  std::string path;  // for messages, and for what the file names by a relative path
  Value root;        // holds Entries
};

// Throws ConfigurationError where the text is not well-formed TOML.
Document parse_toml(const std::string& text, const std::string& path);

ConfigurationError error_at(const std::string& path, Position at, const std::string& message);

// For messages: `the text "500 MW"`, `8000`, `a table`.
std::string describe(const Value& value);

}  // namespace gsbench::keys
