// Where a page of figures goes: a table on the terminal or JSON, and with -o an HTML report.
#pragma once

#include <string>

#include <record/page.hpp>

namespace gsbench::cli {

struct PageOutput {
  bool json = false;
  std::string report;  // "": none; "-": standard output, in place of the table
};

// Before long work: throws render::WriteError where the report cannot be written.
void check_place(const PageOutput& output);
void print_page(const record::Page& page, const PageOutput& output);

}  // namespace gsbench::cli
