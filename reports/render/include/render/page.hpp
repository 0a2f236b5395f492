// A page of figures as text for people and scripts.
#pragma once

#include <string>

#include <record/page.hpp>

namespace gsbench::render {

std::string html(const record::Page& page);  // one file without external resources
// facts{…}, verdict and reasons of a page that is judged, the lists of tables that are named,
// sections[{id, title, paragraphs, tables[{caption, columns, rows[{name, figures}]}],
// plots[{caption, x_axis, y_axis, x, curves[{name, y}]}]}]; null for an empty cell.
std::string json(const record::Page& page);
std::string terminal(const record::Page& page);  // tables and paragraphs, without plots

}  // namespace gsbench::render
