#include "commands.hpp"
#include "json_schema.hpp"

#include <cstdio>
#include <memory>
#include <string>

#include <nlohmann/json.hpp>

#include <keys/markdown.hpp>
#include <profile/keys.hpp>
#include <station/station_file.hpp>

namespace gsbench::cli {
namespace {

struct Arguments {
  std::string format;
  bool markdown = false;
};

const keys::Key& keys_of(const std::string& format) {
  return format == "profile" ? profile::profile_keys()
         : format == "grid"  ? profile::grid_keys()
                             : station::station_keys();
}

void schema(const Arguments& arguments) {
  const keys::Key& keys = keys_of(arguments.format);
  const std::string text =
      arguments.markdown ? keys::markdown(keys) : json_schema(keys).dump(2) + "\n";
  std::fputs(text.c_str(), stdout);
}

}  // namespace

void add_schema(CLI::App& app, int&) {
  auto arguments = std::make_shared<Arguments>();
  CLI::App* command =
      app.add_subcommand("schema", "What a file may say, as a JSON Schema for editors");
  command->add_option("FORMAT", arguments->format, "profile, grid or station")
      ->required()
      ->check(CLI::IsMember({"profile", "grid", "station"}));
  command->add_flag("--markdown", arguments->markdown, "Print as the tables of profiles/README.md");
  command->footer("Example:\n  gsbench schema profile > profile.schema.json");
  command->callback([arguments] { schema(*arguments); });
}

}  // namespace gsbench::cli
