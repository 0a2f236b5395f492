// A study's table, for a terminal and as JSON.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <study/study.hpp>

namespace gsbench::cli {

// Shares asked for: of the values of a measure with a magnitude up to a limit, in its unit.
using Shares = std::vector<std::pair<std::string, double>>;

std::string study_table(const study::StudyResult& study, const Shares& shares);
std::string study_json(const study::StudyResult& study, const Shares& shares);

}  // namespace gsbench::cli
