// What a publication prints for a plan's grid, beside what we work out.
#pragma once

#include <vector>

#include <grid/grid.hpp>
#include <record/run_record.hpp>

namespace gsbench::station {

std::vector<record::Comparison> comparisons(const grid::Grid& grid);

}  // namespace gsbench::station
