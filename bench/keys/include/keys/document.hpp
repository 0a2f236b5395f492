// Parsed TOML values with their positions, and an error type whose message contains a position.
// Only document.cpp uses the TOML library.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace gsbench::keys {

// Bad usage or bad file (profile, grid, station, recording, settings); exit code 2. what() is the
// complete message: `file:line:column: what is wrong, and what would be right`.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The end of a message about a name that is not in `known`: `; did you mean "x"?` if one is
// similar, otherwise `; <what> are: a, b, c`.
std::string suggestion(const std::string& name, const std::vector<std::string>& known,
                       const std::string& what);

struct Position {
  int line = 1;
  int column = 1;
};

struct Entry;
struct Value;
using Array = std::vector<Value>;
using Entries = std::vector<Entry>;  // of a table, in the order of the file
struct DateOrTime {
  std::string text;  // "2025-04-28T11:00:02"
};

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
  std::string path;  // for messages, and the base of relative paths in the file
  Value root;        // holds Entries
};

// Throws ConfigurationError if the text is not valid TOML.
Document parse_toml(const std::string& text, const std::string& path);

ConfigurationError error_at(const std::string& path, Position at, const std::string& message);

// As a TOML file has it: in quotation marks, with escapes.
std::string quoted(const std::string& text);

// For messages: `the text "500 MW"`, `8000`, `a table`.
std::string describe(const Value& value);

}  // namespace gsbench::keys
