#include "arguments.hpp"

#include "commands.hpp"

#include <cstdint>
#include <optional>
#include <utility>

#include <CLI/CLI.hpp>

namespace gsbench::cli {
namespace {

std::string usage_mistake(const CLI::App* app, const CLI::Error& error) {
  const std::vector<std::string> unknown = app->remaining();
  const bool no_command = app->get_subcommands().empty() && !unknown.empty();
  return "gsbench: " + (no_command ? unknown.front() + " is no command" : error.what()) +
         "; `gsbench --help` and `gsbench COMMAND --help` say more\n";
}

}  // namespace

Option Option::required() const {
  return Option(*option_->required());
}

Option Option::show_default() const {
  return Option(*option_->capture_default_str());
}

Option Option::show_default(const std::string& text) const {
  return Option(*option_->default_str(text));
}

template <class Number>
Option Option::range(Number low, Number high) const {
  return Option(*option_->check(CLI::Range(low, high)));
}

template Option Option::range(int, int) const;
template Option Option::range(double, double) const;
template Option Option::range(std::uint64_t, std::uint64_t) const;

Option Option::positive() const {
  return Option(*option_->check(CLI::PositiveNumber));
}

Option Option::one_of(const std::vector<std::string>& words) const {
  return Option(*option_->check(CLI::IsMember(words)));
}

Option Option::existing_folder() const {
  return Option(*option_->check(CLI::ExistingDirectory));
}

Option Option::comma_separated() const {
  return Option(*option_->delimiter(','));
}

Option Option::one_value_each_time() const {
  return Option(*option_->allow_extra_args(false));
}

Option Option::needs(const Option& other) const {
  return Option(*option_->needs(other.option_));
}

Option Option::excludes(const Option& other) const {
  return Option(*option_->excludes(other.option_));
}

template <class Value>
Option Command::option(const std::string& name, Value& value,
                       const std::string& description) const {
  return Option(*app_->add_option(name, value, description));
}

template Option Command::option(const std::string&, std::string&, const std::string&) const;
template Option Command::option(const std::string&, double&, const std::string&) const;
template Option Command::option(const std::string&, int&, const std::string&) const;
template Option Command::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option Command::option(const std::string&, std::optional<std::uint64_t>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::vector<std::string>&,
                                const std::string&) const;
template Option Command::option(const std::string&, std::vector<double>&, const std::string&) const;

Option Command::option_to(const std::string& name,
                          const std::function<void(const std::string&)>& set,
                          const std::string& description) const {
  return Option(*app_->add_option_function(name, set, description));
}

Option Command::flag(const std::string& name, bool& value, const std::string& description) const {
  return Option(*app_->add_flag(name, value, description));
}

void Command::footer(const std::string& text) const {
  app_->footer(text);
}

void Command::callback(std::function<int()> run) const {
  app_->callback([run = std::move(run), exit_code = exit_code_] { *exit_code = run(); });
}

CommandLine::CommandLine(const std::string& about, const std::string& footer,
                         const std::string& version)
    : app_(std::make_unique<CLI::App>(about, "gsbench")) {
  app_->footer(footer);
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
  app_->failure_message(usage_mistake);
}

CommandLine::~CommandLine() = default;

Command CommandLine::command(const std::string& name, const std::string& description) {
  return Command(*app_->add_subcommand(name, description), exit_code_);
}

int CommandLine::run(int argc, char** argv) {
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app_->exit(error) == 0 ? kPassed : kBadInput;
  }
  return exit_code_;
}

}  // namespace gsbench::cli
