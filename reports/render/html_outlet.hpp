// An outlet's part of an HTML report: its row of key figures and its tables.
#pragma once

#include "html_elements.hpp"
#include "key_figures.hpp"

#include <vector>

namespace gsbench::render {

object outlet_object(const record::RunRecord& run, std::size_t index,
                     const std::vector<KeyFigure>& keys);

}  // namespace gsbench::render
