#pragma once

#include <stdexcept>

namespace gsbench::keys {

// Bad usage, profile, grid, station or settings: exit code 2. what() is the whole message:
// `file:line:column: what, and what would be right`.
class ConfigurationError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace gsbench::keys
