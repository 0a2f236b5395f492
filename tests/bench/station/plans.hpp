// Plans to run, from the text of their profiles.
#pragma once

#include <string>

#include <profile/load.hpp>

namespace gsbench::station::test {

inline profile::Plan parse(const std::string& text) {
  return profile::parse_profile(text, "test.toml");
}

// Two outlets on the modified IEEE 24-bus system, 8 kHz, for `duration_s`, with `more` before the
// outlets and `expect` after them: whole TOML tables.
inline std::string profile_text(double duration_s, const std::string& more = "",
                                const std::string& outlet = "[[outlet]]\ncount = 2\n") {
  return "title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
         "duration_s = " +
         std::to_string(duration_s) + "\n" + more + outlet +
         "[[expect]]\nmeasure = \"event.count\"\nmax = 0\n";
}

inline profile::Plan plan(double duration_s, const std::string& more = "",
                          const std::string& outlet = "[[outlet]]\ncount = 2\n") {
  return parse(profile_text(duration_s, more, outlet));
}

}  // namespace gsbench::station::test
