#include "commands.hpp"
#include "live_output.hpp"
#include "progress.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include <station/safe_state.hpp>
#include <station/station_file.hpp>
#include <station/station_lock.hpp>

namespace gsbench::cli {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr auto kBetweenAttempts = std::chrono::milliseconds(500);

struct SafeArguments {
  std::string station;
  double wait_s = 60.0;
};

// A new connection for each attempt: an instrument that reboots closes the old one.
drivers::Status attempt(const station::StationFile& file, std::string& name) {
  const std::shared_ptr<source::Source> source = file.make_source();
  name = source->limits().name;
  return source->make_safe();
}

int safe(const SafeArguments& arguments) {
  const station::StationFile file = station::load_station(arguments.station);
  if (!file.make_source) {
    throw profile::ConfigurationError(
        file.path + ": this station has no source that outlives the bench; nothing is to be done");
  }
  const std::string holder = station::lock_holder(file.source_port);
  if (!holder.empty()) {
    print_error(fmt::format("{}: in use by another bench: {}; its run will fail", file.source_port,
                            holder));
  }
  const std::atomic<bool>& interrupted = catch_interrupts();
  const LiveOutput live(file, arguments.station);
  Progress progress("safe " + file.name);
  const auto end = steady_clock::now() + duration<double>(arguments.wait_s);
  std::string name;
  while (true) {
    const drivers::Status done = attempt(file, name);
    if (done.ok()) {
      print_wrapped(fmt::format("{}: {}: output off", file.source_port, name));
      return kPassed;
    }
    const double left_s = duration<double>(end - steady_clock::now()).count();
    if (interrupted || left_s <= 0.0) {
      print_error(station::unknown_state(done.error()));
      return interrupted ? kInterrupted : kErrored;
    }
    progress.show(fmt::format("{}; {:.0f} s left", done.error(), std::ceil(left_s)));
    std::this_thread::sleep_for(kBetweenAttempts);
  }
}

}  // namespace

void add_safe(CommandLine& line) {
  const auto [command, arguments] = line.command(
      "safe", "Switch the source of a physical station off, after a bench that was killed", safe);
  command.add_option("STATION", arguments.station, "Name of a station, or a .toml file")
      ->type_name("STATION")
      ->required();
  add_with_default(command, "--wait", arguments.wait_s, "S",
                   "Time to try for if the instrument does not answer, 0 to 3600 s")
      ->check(CLI::Range(0.0, 3600.0));
  command.footer(
      "Connects to the instrument, switches its output off and asks whether it is. It may be\n"
      "called at any time, more than once, and while a bench uses the station. Exit code 0: the\n"
      "output is off; 4: the state of the output is unknown, and the message says what to do.\n"
      "\n"
      "Examples:\n"
      "  gsbench safe my-station.toml\n"
      "  gsbench safe my-station.toml --wait 300");
}

}  // namespace gsbench::cli
