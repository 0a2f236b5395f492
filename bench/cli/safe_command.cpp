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
constexpr double kLongestWait_s = 3600.0;

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
  // After a hang-up it goes on: nothing is better than the output off.
  static_cast<void>(catch_interrupts());
  const LiveOutput live(file, arguments.station, LiveOutput::FirstSignal::kEnd);
  Progress progress("safe " + file.name);
  const auto end = steady_clock::now() + duration<double>(arguments.wait_s);
  std::string name;
  while (true) {
    const drivers::Status done = attempt(file, name);
    if (done.ok()) {
      print_wrapped(fmt::format("{}: {}: output off", file.source_port, name));
      return kPassed;
    }
    const auto next = steady_clock::now() + kBetweenAttempts;
    if (next >= end) {
      progress.clear();
      print_error(station::unknown_state(done.error()));
      return kErrored;
    }
    progress.show(fmt::format("{}; {:.0f} s left", done.error(),
                              std::ceil(duration<double>(end - next).count())));
    std::this_thread::sleep_until(next);
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
                   "Time after which no new attempt begins if the instrument does not answer, 0 to "
                   "3600 s; 0: one attempt")
      ->check(number_between(0.0, kLongestWait_s));
  command.footer(
      "Connects to the instrument, switches its output off and asks whether it is. It may be\n"
      "called at any time, more than once, and while a bench uses the station. Exit code 0: the\n"
      "output is off; 4: the state of the output is unknown, and the message says what to do;\n"
      "130: interrupted, state unknown. One attempt lasts about 5 s at most: two answers of the\n"
      "instrument, which have 2 s each unless its file says otherwise, and 1 s to connect.\n"
      "\n"
      "Examples:\n"
      "  gsbench safe my-station.toml\n"
      "  gsbench safe my-station.toml --wait 300");
}

}  // namespace gsbench::cli
