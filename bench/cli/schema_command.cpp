#include "commands.hpp"
#include "json_schema.hpp"

#include <cstdio>
#include <memory>
#include <string>

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
  std::fputs((arguments.markdown ? keys::markdown(keys) : json_schema(keys)).c_str(), stdout);
}

}  // namespace

void add_schema(CommandLine& line) {
  auto arguments = std::make_shared<Arguments>();
  const Command command =
      line.command("schema", "What a file may say, as a JSON Schema for editors");
  command.option("FORMAT", arguments->format, "profile, grid or station")
      .required()
      .one_of({"profile", "grid", "station"});
  command.flag("--markdown", arguments->markdown, "Print as the tables of profiles/README.md");
  command.footer("Example:\n  gsbench schema profile > profile.schema.json");
  command.callback([arguments] {
    schema(*arguments);
    return kPassed;
  });
}

}  // namespace gsbench::cli
