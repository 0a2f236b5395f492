// The page of `gsbench immunity`.
#pragma once

#include <cstdint>

#include <immunity/study.hpp>
#include <record/page.hpp>

namespace gsbench::immunity {

// All cases. The first failing case of each kind is printed as the [signal] keys of a profile.
// After a stop, it fails by a trip, and is not judged without one.
record::Page make_page(const grid::Grid& grid, const Options& options,
                       const campaign::Execution& execution);

// One case alone. It fails if the relay opens; and if it is a dip, also by an event.
record::Page make_page_of_case(const grid::Grid& grid, const Options& options, std::uint32_t number,
                               const campaign::Execution& execution);

}  // namespace gsbench::immunity
