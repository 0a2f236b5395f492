// The help of gsbench and its commands.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace gsbench::cli {

// Formats the help in lines of at most render::kLineColumns columns. An option is shown with the
// name of its value. After its description come the option that it needs, its default, and
// "(required)".
std::shared_ptr<CLI::Formatter> help_formatter();

std::vector<const CLI::App*> commands_of(const CLI::App& app);
std::vector<std::string> command_names(const CLI::App& app);

// False for a flag.
bool takes_value(const CLI::Option& option);

// "PROFILE", "N": what an option takes.
std::string value_name(const CLI::Option& option);

// The option's description, followed by the option that it needs and its default.
std::string description_of(const CLI::Option& option);

}  // namespace gsbench::cli
