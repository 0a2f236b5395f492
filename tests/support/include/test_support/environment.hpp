#pragma once

#include <cstdlib>
#include <map>
#include <optional>
#include <string>

namespace gsbench::test {

// Sets or unsets environment variables for the length of a test.
class Environment {
 public:
  void set(const std::string& name, const char* value) {
    const char* before = std::getenv(name.c_str());
    before_.emplace(name, before != nullptr ? std::optional<std::string>(before) : std::nullopt);
    apply(name, value);
  }
  Environment() = default;
  ~Environment() {
    for (const auto& [name, value] : before_) {
      apply(name, value ? value->c_str() : nullptr);
    }
  }
  Environment(const Environment&) = delete;
  Environment& operator=(const Environment&) = delete;

 private:
  static void apply(const std::string& name, const char* value) {
    if (value != nullptr) {
      ::setenv(name.c_str(), value, 1);
    } else {
      ::unsetenv(name.c_str());
    }
  }

  std::map<std::string, std::optional<std::string>> before_;
};

}  // namespace gsbench::test
