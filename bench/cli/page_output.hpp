// Output of a page of figures: tables or JSON, and an HTML report with -o.
#pragma once

#include "commands.hpp"

#include <cstddef>
#include <functional>
#include <string>

#include <campaign/work.hpp>
#include <record/page.hpp>

namespace gsbench::cli {

struct PageOutput {
  bool json = false;
  std::string report;  // "": none; "-": standard output, in place of the table
  std::size_t threads = 1;
};

// -o, --json and --threads.
void add_page_options(CLI::App& command, PageOutput& output);

// Computes a page with `make` and prints it. Shows the progress on a terminal; Ctrl-C sets
// Execution::stop. Returns the exit code: kFailed for a page whose judgement fails. Throws
// profile::ConfigurationError if `make` throws std::invalid_argument. Throws render::WriteError if
// the report cannot be written; this is also tested before the call of `make`.
int print_page(const char* what, const PageOutput& output,
               const std::function<record::Page(const campaign::Execution&)>& make);

}  // namespace gsbench::cli
