// The sections, one function each or a few that share their campaigns.
#pragma once

#include <reproduce/reproduction.hpp>

namespace gsbench::reproduce {

using campaign::Execution;
using record::PageSection;

PageSection fig8_and_13(const grid::Grid& grid);
PageSection fig9_and_table1(const grid::Grid& grid);
PageSection fig14(const grid::Grid& grid);
PageSection table2(const grid::Grid& grid, const Options& options, const Execution& execution);
PageSection table3(const grid::Grid& grid, const Options& options, const Execution& execution);
PageSection fig16(const grid::Grid& grid, const Options& options);
PageSection table4(const grid::Grid& grid, const Options& options, const Execution& execution);
PageSection table5(const grid::Grid& grid, const Options& options, const Execution& execution);
PageSection fig20_and_21(const grid::Grid& grid, const Options& options,
                         const Execution& execution);
PageSection fig22(const grid::Grid& grid, const Options& options, const Execution& execution);

}  // namespace gsbench::reproduce
