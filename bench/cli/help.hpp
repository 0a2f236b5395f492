// The help of gsbench and its commands.
#pragma once

#include <memory>
#include <string>

#include <CLI/CLI.hpp>

namespace gsbench::cli {

// Lines of at most render::kLineColumns. An option is shown with the name of its value; its
// default, and the option that it needs, follow the description.
std::shared_ptr<CLI::Formatter> help_formatter();

// "PROFILE", "N": what an option takes.
std::string value_name(const CLI::Option& option);

// Its description, with the option that it needs and its default.
std::string description_of(const CLI::Option& option);

}  // namespace gsbench::cli
