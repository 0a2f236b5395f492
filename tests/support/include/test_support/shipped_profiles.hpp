// The shipped profiles as parameters of tests. CMake: gs_tests_of_profiles(TARGET).
#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <profile/files.hpp>
#include <profile/load.hpp>

namespace gsbench::test {

// Sorted. `folder`: such as "cascades/"; empty: all.
inline std::vector<std::string> shipped_profiles(const std::string& folder = "") {
  std::vector<std::string> names;
  for (const profile::NamedFile& file : profile::all_profiles()) {
    const bool is_shipped = file.path.rfind(profile::profiles_folder(), 0) == 0;
    if (is_shipped && file.name.rfind(folder, 0) == 0) {
      names.push_back(file.name);
    }
  }
  return names;
}

// "paper/loss-500mw" as a part of a test's name.
inline std::string test_name(const testing::TestParamInfo<std::string>& profile) {
  std::string name = profile.param;
  std::replace_if(
      name.begin(), name.end(),
      [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0; }, '_');
  return name;
}

}  // namespace gsbench::test
