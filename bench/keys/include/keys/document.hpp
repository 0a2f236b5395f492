// A TOML file as plain values, each with its place in the file, and the error that names such a
// place. Only document.cpp knows the TOML library.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace gsbench::keys {

// Bad usage, profile, grid, station or settings: exit code 2. what() is the whole message:
// `file:line:column: what, and what would be right`.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The end of a message on a word that is none of `known`: `; did you mean "x"?` where one is near,
// else `; <what> are: a, b, c`.
std::string suggestion(const std::string& word, const std::vector<std::string>& known,
                       const std::string& what);

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
