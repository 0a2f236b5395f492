// The figures that tests/README.md claims are those that its commands print.
#include "gsbench_process.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace gsbench::test {
namespace {

using Figure = std::function<double(const json&)>;

struct Claim {
  std::string text;  // in the command's row; its group is the figure
  Figure figure;     // from the command's --json
};

struct Row {
  std::string command;  // behind "./dev gsbench"
  std::vector<Claim> claims;
};

const json& named(const json& list, const std::string& key, const std::string& name) {
  const auto found =
      std::find_if(list.begin(), list.end(), [&](const json& entry) { return entry[key] == name; });
  if (found == list.end()) {
    throw std::runtime_error("nothing has the " + key + " " + name);
  }
  return *found;
}

Figure measure(const std::string& name, const std::string& statistic) {
  return [=](const json& study) {
    return named(study["measures"], "name", name)[statistic].get<double>();
  };
}

Figure share_within(double limit) {
  return [=](const json& study) {
    return 100.0 * named(study["shares"], "within", std::to_string(limit))["share"].get<double>();
  };
}

// A figure of the table whose caption matches, in the row and the column that begin so.
Figure cell(const std::string& section, const std::string& caption, const std::string& row,
            const std::string& column) {
  const auto begins = [](const std::string& text, const std::string& beginning) {
    return text.compare(0, beginning.size(), beginning) == 0;
  };
  return [=](const json& page) {
    for (const json& table : named(page["sections"], "id", section)["tables"]) {
      for (const json& line : table["rows"]) {
        for (std::size_t i = 0; i < table["columns"].size(); ++i) {
          if (begins(table["caption"], caption) && begins(line["name"], row) &&
              begins(table["columns"][i], column)) {
            return line["figures"][i].get<double>();
          }
        }
      }
    }
    throw std::runtime_error(section + " has no " + row + ", " + column);
  };
}
