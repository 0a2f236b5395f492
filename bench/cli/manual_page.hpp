// The manual page gsbench(1), from the definitions of the commands and their options.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace gsbench::cli {

// Returns the page in the man macros of roff, man(7).
std::string manual_page(const CLI::App& app);

}  // namespace gsbench::cli
