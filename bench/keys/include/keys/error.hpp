#pragma once

#include <stdexcept>
#include <string>
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

}  // namespace gsbench::keys
