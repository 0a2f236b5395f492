// A run's record as text for people and machines: pure functions of the record, and a table of
// them. A new format needs its own .cpp file, its declaration and row here, and its line in
// CMakeLists.txt.
#pragma once

#include <string>
#include <string_view>

#include <record/run_record.hpp>

namespace gsbench::render {

std::string terminal(const record::RunRecord& run);
// The same with ANSI colours and with all lines wrapped to kLineColumns.
std::string coloured_terminal(const record::RunRecord& run);
std::string html(const record::RunRecord& run);
std::string json(const record::RunRecord& run);
std::string junit_xml(const record::RunRecord& run);
std::string csv(const record::RunRecord& run);

struct Format {
  const char* name;  // value of `gsbench report --format`
  const char* file;  // in the run's folder; empty: not kept there
  const char* description;
  std::string (*render)(const record::RunRecord& run);

  constexpr bool is_kept() const { return file[0] != '\0'; }
};

inline constexpr Format kFormats[] = {
    {"terminal", "", "a table of the outlets, and the measurements that did not pass", terminal},
    {"html", "report.html", "a report for browsers, in one file", html},
    {"json", "result.json", "all results, for scripts", json},
    {"junit", "junit.xml", "JUnit XML: a test suite per outlet, a test case per measurement",
     junit_xml},
    {"csv", "traces.csv", "what each outlet measured and estimated, with the reference frequency",
     csv},
};

// nullptr if no format has that name.
constexpr const Format* find_format(std::string_view name) {
  for (const Format& format : kFormats) {
    if (name == format.name) {
      return &format;
    }
  }
  return nullptr;
}

}  // namespace gsbench::render
