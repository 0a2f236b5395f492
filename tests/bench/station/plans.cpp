#include "plans.hpp"

#include <profile/load.hpp>

namespace gsbench::station::test {

profile::Plan parse(const std::string& text) {
  return profile::parse_profile(text, "test.toml");
}

std::string profile_text(double duration_s, const std::string& more, const std::string& outlet) {
  return "title = \"A test\"\nsource = \"None\"\n[grid]\nsystem = \"ieee24\"\n[signal]\n"
         "duration_s = " +
         std::to_string(duration_s) + "\n" + more + outlet +
         "[[expect]]\nmeasure = \"event.count\"\nmax = 0\n";
}

profile::Plan plan(double duration_s, const std::string& more, const std::string& outlet) {
  return parse(profile_text(duration_s, more, outlet));
}

}  // namespace gsbench::station::test
