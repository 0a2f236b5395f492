#include "help.hpp"

#include <string>

#include <render/layout.hpp>

namespace gsbench::cli {
namespace {

class HelpFormatter : public CLI::Formatter {
 public:
  HelpFormatter() {
    label("Positionals", "Arguments");
    label("SUBCOMMAND", "COMMAND");
  }

  std::string make_description(const CLI::App* app) const override {
    return render::wrapped(app->get_description()) + '\n';
  }

  std::string make_subcommand(const CLI::App* command) const override {
    return entry(command->get_name(), command->get_description());
  }

  std::string make_option(const CLI::Option* option, bool is_positional) const override {
    std::string name = make_option_name(option, is_positional);
    if (takes_value(*option) && !is_positional) {
      name += ' ' + value_name(*option);
    }
    return entry(name, description_of(*option));
  }

 private:
  // In two columns; a long name has a line of its own.
  static std::string entry(const std::string& name, const std::string& text) {
    constexpr std::size_t kTextColumn = 28;
    const std::string start = "  " + name;
    const std::size_t used = render::columns_of(start);
    const std::string gap = used + 2 > kTextColumn ? '\n' + std::string(kTextColumn, ' ')
                                                   : std::string(kTextColumn - used, ' ');
    // The indentation of a wrapped text starts after a line end of its own.
    const std::string lines =
        render::wrapped(std::string(kTextColumn, ' ') + text, render::kLineColumns, kTextColumn);
    return start + gap + lines.substr(kTextColumn) + '\n';
  }
};

}  // namespace

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) {
    names.push_back(command->get_name());
  }
  return names;
}

bool takes_value(const CLI::Option& option) {
  return option.get_items_expected_max() > 0;
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.substr(0, type.find(':'));  // CLI11 adds ":" and the checks
}

std::string description_of(const CLI::Option& option) {
  std::string text = option.get_description();
  for (const CLI::Option* needed : option.get_needs()) {
    text += "; needs " + needed->get_name();
  }
  if (takes_value(option) && !option.get_default_str().empty()) {
    text += " (default: " + option.get_default_str() + ')';
  }
  if (option.get_required() && !option.get_positional()) {
    text += " (required)";
  }
  return text;
}

std::shared_ptr<CLI::Formatter> help_formatter() {
  return std::make_shared<HelpFormatter>();
}

}  // namespace gsbench::cli
