// Plans for tests, made from the text of a profile.
#pragma once

#include <string>

#include <profile/load.hpp>

namespace gsbench::station::test {

inline profile::Plan parse(const std::string& text) {
  return profile::parse_profile(text, "test.toml");
}

// A profile of two outlets on the modified IEEE 24-bus system at 8 kHz. `more` comes after the keys
// of [signal]; `outlet` replaces the outlets.
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
