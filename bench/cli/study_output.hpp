// A study's table, for a terminal and as JSON.
#pragma once

#include <seed_sweep/seed_sweep.hpp>

#include <string>
#include <utility>
#include <vector>

namespace gsbench::cli {

// Shares asked for: of the values of a measure with a magnitude up to a limit, in the catalogue's
// unit.
using Shares = std::vector<std::pair<std::string, double>>;

std::string study_table(const seed_sweep::StudyResult& study, const Shares& shares);
std::string study_json(const profile::Plan& plan, std::uint64_t first_seed,
                       const seed_sweep::StudyResult& study, const Shares& shares);

// nullptr where the study has no such measure.
const seed_sweep::Row* find_row(const seed_sweep::StudyResult& study, const std::string& measure);

}  // namespace gsbench::cli
