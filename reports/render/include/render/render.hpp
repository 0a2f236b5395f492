// A run's record as text for people and machines: pure functions of the record, and the one table
// of them. A new format is its own .cpp, its declaration and row here, and its line in
// CMakeLists.txt.
#pragma once

#include <string>
#include <string_view>

#include <record/run_record.hpp>

namespace gsbench::render {

std::string terminal(const record::RunRecord& run);
std::string coloured_terminal(const record::RunRecord& run);  // the same with ANSI colours
std::string html(const record::RunRecord& run);
std::string json(const record::RunRecord& run);
std::string junit_xml(const record::RunRecord& run);
std::string csv(const record::RunRecord& run);

struct Format {
  const char* name;  // of `gsbench report --format`
  const char* file;  // in a run's folder; empty: not kept there
  const char* description;
  std::string (*render)(const record::RunRecord& run);

  constexpr bool is_kept() const { return file[0] != '\0'; }
};

inline constexpr Format kFormats[] = {
    {"terminal", "", "a short table of the outlets and what did not pass", terminal},
    {"html", "report.html", "a page that stands alone in one file", html},
    {"json", "result.json", "keys that scripts may rely on, see README", json},
    {"junit", "junit.xml", "a test suite per outlet, a test case per measurement", junit_xml},
    {"csv", "traces.csv", "a row per outlet and report, the reference beside it", csv},
};

// nullptr where no format has that name.
constexpr const Format* find_format(std::string_view name) {
  for (const Format& format : kFormats) {
    if (name == format.name) {
      return &format;
    }
  }
  return nullptr;
}

}  // namespace gsbench::render
