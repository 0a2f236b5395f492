// The figures that tests/README.md claims are those that its commands print.
#include "gsbench_process.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <iterator>
#include <ostream>
#include <regex>
#include <sstream>
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

void PrintTo(const Row& row, std::ostream* out) {
  *out << row.command;
}

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
    for (const json& share : study["shares"]) {
      if (share["within"] == limit) {
        return 100.0 * share["share"].get<double>();
      }
    }
    throw std::runtime_error("no share within the limit");
  };
}

bool begins(const std::string& text, const std::string& beginning) {
  return text.compare(0, beginning.size(), beginning) == 0;
}

// The figure of `section` in a row and column that begin so, of the first table that has both.
Figure cell(const std::string& section, const std::string& row, const std::string& column) {
  return [=](const json& page) {
    for (const json& table : named(page["sections"], "id", section)["tables"]) {
      for (const json& line : table["rows"]) {
        for (std::size_t i = 0; i < table["columns"].size(); ++i) {
          if (begins(line["name"], row) && begins(table["columns"][i], column)) {
            return line["figures"][i].get<double>();
          }
        }
      }
    }
    throw std::runtime_error(section + " has no " + row + ", " + column);
  };
}

const std::vector<Row>& rows() {
  static const std::vector<Row> all = {
      {"params ieee24",
       {{"([0-9.]+) MW;", [](const json& grid) { return grid["threshold_mw"].get<double>(); }}}},
      {"study paper/loss-500mw --seeds 200",
       {{"event after ([0-9]+) ms \\(p50\\)", measure("event.delay", "p50")},
        {"\\(p50\\), ([0-9]+) ms \\(p99\\)", measure("event.delay", "p99")},
        {"decision after ([0-9]+) ms at most", measure("decision.delay", "max")},
        {"within 1 % in ([0-9.]+) %", share_within(1.0)},
        {"within 4 % in ([0-9.]+) %", share_within(4.0)}}},
      {"reproduce --only table4",
       {{"([0-9.]+) % of a million estimates within 4 %",
         cell("table4", "firmware, known", "within 4 %")},
        {"σ ([0-9.]+) p.u.", cell("table4", "firmware, known", "σ, p.u.")},
        {"which is ([0-9.]+) times the", cell("table4", "firmware, known", "σ/bound")},
        {"Gaussian: ([0-9.]+) %", cell("table4", "firmware, Gaussian, on", "within 4 %")},
        {"and ([0-9.]+) % if", cell("table4", "firmware, Gaussian, between", "within 4 %")}}},
      {"reproduce --only table5,table2",
       {{"([0-9.]+) % within 4 %", cell("table5", "experiment: reconciled", "within 4 %")}}},
      {"reproduce --only fig21,fig22",
       {{"([0-9.]+) MW shed \\(the paper: 148.34", cell("fig21", "firmware, known", "shed, MW")},
        {"required ([0-9.]+) MW", cell("fig21", "required", "shed, MW")},
        {"errors up to 5 %: ([0-9.]+) MW", cell("fig21", "experiment", "shed, MW")},
        {"nadir ([0-9.]+) Hz", cell("fig22", "with Grid Sense", "nadir, Hz")},
        {"and ([0-9.]+) Hz with", cell("fig22", "delay-aware", "nadir, Hz")}}},
      {"fleet --closed-loop",
       {{"required ([0-9.]+) MW", cell("closed-loop", "required", "threshold loss by")},
        {"\\(15\\): ([0-9.]+) MW", cell("closed-loop", "shed, MW", "threshold loss by")},
        {"delay-aware threshold: ([0-9.]+) MW", cell("closed-loop", "shed, MW", "delay-aware")}}},
  };
  return all;
}

// The line of tests/README.md with this command.
std::string claimed(const std::string& command) {
  std::istringstream readme(text_of(GSBENCH_SOURCE_DIR "/tests/README.md"));
  for (std::string line; std::getline(readme, line);) {
    if (line.find("| `./dev gsbench " + command + "` |") != std::string::npos) {
      return line;
    }
  }
  throw std::runtime_error("tests/README.md has no row with the command " + command);
}

Words split(const std::string& command) {
  std::istringstream words(command);
  return {std::istream_iterator<std::string>(words), {}};
}

class ClaimedFigures : public testing::TestWithParam<Row> {};

TEST_P(ClaimedFigures, EqualTheOutputOfTheirCommand) {
  const std::string line = claimed(GetParam().command);
  Words arguments = split(GetParam().command);
  arguments.emplace_back("--json");
  const json printed = run_for_json(arguments);
  for (const Claim& claim : GetParam().claims) {
    std::smatch found;
    ASSERT_TRUE(std::regex_search(line, found, std::regex(claim.text))) << claim.text;
    const std::string figure = found[1];
    // Half a unit of the last digit, and a little more for figures in binary.
    const std::size_t point = figure.find('.');
    const auto decimals =
        static_cast<double>(point == std::string::npos ? 0 : figure.size() - point - 1);
    EXPECT_NEAR(claim.figure(printed), std::stod(figure), 0.5001 * std::pow(10.0, -decimals))
        << claim.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Readme, ClaimedFigures, testing::ValuesIn(rows()), [](const auto& row) {
  std::string name = row.param.command;
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
});

}  // namespace
}  // namespace gsbench::test
