// What the command line accepts: commands, their options and positional arguments, and the values
// of each. Help and the refusal of bad usage come from these definitions. CLI11, which takes each
// file that includes it some seconds, is known to arguments.cpp alone.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace gsbench::cli {

// An option, or a positional argument. A handle: the CommandLine owns what it stands for.
class Option {
 public:
  explicit Option(CLI::Option& option) : option_(&option) {}

  Option required() const;
  Option show_default() const;  // in the help: the value that the variable has now
  Option show_default(const std::string& text) const;
  // int, double or std::uint64_t, low and high included. Lets NaN pass.
  template <class Number>
  Option range(Number low, Number high) const;
  Option positive() const;
  Option one_of(const std::vector<std::string>& words) const;
  Option existing_folder() const;
  Option comma_separated() const;
  Option one_value_each_time() const;  // of a list: --name a --name b, but not --name a b
  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;

 private:
  CLI::Option* option_;
};

class Command {
 public:
  Command(CLI::App& app, int& exit_code) : app_(&app), exit_code_(&exit_code) {}

  // `name`: "--port", "-o,--output", or "profile" for a positional argument. `value` is set as the
  // command line is parsed, and must live as long as the CommandLine. Value: std::string, double,
  // int, std::uint64_t, std::optional<std::uint64_t>, or a vector of strings or doubles.
  template <class Value>
  Option option(const std::string& name, Value& value, const std::string& description) const;
  // The same with any other type: `set` is given the text.
  Option option_to(const std::string& name, const std::function<void(const std::string&)>& set,
                   const std::string& description) const;
  Option flag(const std::string& name, bool& value, const std::string& description) const;
  void footer(const std::string& text) const;
  // What the command does, once all is parsed; returns the exit code.
  void callback(std::function<int()> run) const;

 private:
  CLI::App* app_;
  int* exit_code_;
};

class CommandLine {
 public:
  CommandLine(const std::string& about, const std::string& footer, const std::string& version);
  ~CommandLine();

  Command command(const std::string& name, const std::string& description);

  // Runs the command that is named. Returns its exit code, or kBadInput where the usage was bad and
  // has been refused on stderr. What the command throws passes through.
  int run(int argc, char** argv);

 private:
  std::unique_ptr<CLI::App> app_;
  int exit_code_ = 0;
};

}  // namespace gsbench::cli
