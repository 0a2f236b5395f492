// The help of gsbench and its commands.
#pragma once

#include <memory>

#include <CLI/CLI.hpp>

namespace gsbench::cli {

// Lines of at most render::kLineColumns. An option is shown with the name of its value; its
// default, and the option that it needs, follow the description.
std::shared_ptr<CLI::Formatter> help_formatter();

}  // namespace gsbench::cli
