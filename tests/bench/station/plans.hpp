// Plans to run, from the text of their profiles.
#pragma once

#include <string>

#include <profile/plan.hpp>

namespace gsbench::station::test {

profile::Plan parse(const std::string& text);

// Two outlets on the modified IEEE 24-bus system, 8 kHz, for `duration_s`, with `more` before the
// outlets and `expect` after them: whole TOML tables.
std::string profile_text(double duration_s, const std::string& more = "",
                         const std::string& outlet = "[[outlet]]\ncount = 2\n");
profile::Plan plan(double duration_s, const std::string& more = "",
                   const std::string& outlet = "[[outlet]]\ncount = 2\n");

}  // namespace gsbench::station::test
