#include "commands.hpp"
#include "link_arguments.hpp"

#include <algorithm>
#include <cstdio>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <link/version_text.hpp>

namespace gsbench::cli {
namespace {

struct DevicesArguments {
  LinkArguments link;
  bool json = false;
};

nlohmann::ordered_json as_json(const link::OutletPresence& outlet) {
  const gs::wire::Hello& hello = outlet.hello;
  return {{"id", outlet.id},
          {"where", outlet.where},
          {"fault", outlet.fault},
          {"board", hello.board},
          {"instance", hello.instance},
          {"protocol", hello.protocol_version},
          {"firmware", link::version_text(hello.firmware_version)},
          {"build", fmt::format("{:08x}", hello.build)},
          {"sample_rate_hz", hello.sample_rate_hz},
          {"nominal_hz", hello.nominal_hz},
          {"settings_version", hello.settings_version},
          {"settings_digest", fmt::format("{:08x}", hello.settings_digest)},
          {"keeps_settings", (hello.capabilities & gs::wire::kKeepsSettings) != 0},
          {"has_watchdog", (hello.capabilities & gs::wire::kHasWatchdog) != 0}};
}

int devices(const DevicesArguments& arguments) {
  const std::vector<link::OutletPresence> present = find_outlets(arguments.link).outlets;
  const bool at_fault = std::any_of(present.begin(), present.end(),
                                    [](const auto& outlet) { return !outlet.fault.empty(); });
  const ExitCode exit_code = at_fault ? kErrored : kPassed;
  if (arguments.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const link::OutletPresence& outlet : present) {
      all.push_back(as_json(outlet));
    }
    print_json(all);
    return exit_code;
  }
  if (present.empty()) {
    std::fputs("gsbench: no outlet answers\n", stderr);
    return kPassed;
  }
  fmt::print("{:<24}{:<28}{:<14}{:<10}{:<10}{:>9}{:>9}  {}\n", "outlet", "where", "board",
             "firmware", "build", "samples", "nominal", "settings");
  for (const link::OutletPresence& outlet : present) {
    if (!outlet.fault.empty()) {
      fmt::print("{:<24}{:<28}! {}\n", outlet.id, outlet.where, outlet.fault);
      continue;
    }
    const gs::wire::Hello& hello = outlet.hello;
    fmt::print("{:<24}{:<28}{:<14}{:<10}{:08x}  {:>6} Hz{:>6} Hz  {}\n", outlet.id, outlet.where,
               hello.board, link::version_text(hello.firmware_version), hello.build,
               hello.sample_rate_hz, hello.nominal_hz,
               hello.settings_version == 0
                   ? std::string("none")
                   : fmt::format("version {}, digest {:08x}", hello.settings_version,
                                 hello.settings_digest));
  }
  return exit_code;
}

}  // namespace

void add_devices(CommandLine& line) {
  const auto [command, arguments] =
      line.command("devices", "Finds outlets on ports and brokers", devices);
  add_link_options(command, arguments.link);
  command.add_flag("--json", arguments.json, "Print as JSON");
  command.footer(
      "Exit code 4 if an outlet does not answer, has another's id, or uses another protocol.\n"
      "\n"
      "Examples:\n"
      "  gsbench devices                          on every serial port of this machine\n"
      "  gsbench devices --port /dev/ttyUSB0\n"
      "  gsbench devices --station my-station.toml");
}

}  // namespace gsbench::cli
