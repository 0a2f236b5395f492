// Where a page of figures goes: a table on the terminal or JSON, and with -o an HTML report.
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

// The page that `make` works out, with progress on a terminal and an end at an interrupt, which it
// is told of by the execution's `stop`. Returns the exit code. Throws profile::ConfigurationError
// for what makes no sense to `make`, and render::WriteError, before it, where the report cannot be
// written.
int print_page(const char* what, const PageOutput& output,
               const std::function<record::Page(const campaign::Execution&)>& make);

}  // namespace gsbench::cli
