// A run's record as text for people and machines, and a table of these formats. A new format needs
// its own .cpp file, its declaration and row here, and its line in CMakeLists.txt.
#pragma once

#include <string>
#include <string_view>

#include <render/view.hpp>

namespace gsbench::render {

// At most 40 lines if more than 32 outlets are shown.
std::string terminal(const View& view);
// The same with ANSI colours and with all lines wrapped to kLineColumns.
std::string coloured_terminal(const View& view);
// Below 5 MB whatever the run: rows of at most 1000 outlets, curves and measurements of at most 20.
std::string html(const View& view);
std::string json(const View& view);
std::string junit_xml(const View& view);
std::string csv(const View& view);
// The same, outlet by outlet.
void write_csv(const View& view, const Sink& sink);

struct Format {
  const char* name;  // value of `gsbench report --format`
  const char* file;  // in the run's folder; empty: not kept there
  const char* description;
  std::string (*render)(const View& view);
  void (*write_in_parts)(const View& view, const Sink& sink) = nullptr;  // if it may be long
  bool on_request = false;  // the file is kept if the user asked for it

  constexpr bool is_kept() const { return file[0] != '\0' && !on_request; }
  void write(const View& view, const Sink& sink) const;
};

inline constexpr Format kFormats[] = {
    {"terminal", "", "a table of the outlets, and the measurements that did not pass", terminal},
    {"html", "report.html", "a report for browsers, in one file", html},
    {"json", "result.json", "all results, for scripts", json},
    {"junit", "junit.xml", "JUnit XML: a test suite per outlet, a test case per measurement",
     junit_xml},
    {"csv", "traces.csv", "what each outlet measured and estimated, with the reference frequency",
     csv, write_csv, true},
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
