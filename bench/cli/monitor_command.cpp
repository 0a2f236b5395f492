#include "commands.hpp"
#include "interrupt.hpp"
#include "link_arguments.hpp"
#include "message_text.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

constexpr auto kBetweenLooks = std::chrono::milliseconds(20);

struct MonitorArguments {
  LinkArguments link;
  std::string outlet;
  double seconds = std::numeric_limits<double>::infinity();
  bool quiet = false;
};

bool wanted(const MonitorArguments& arguments, const std::string& id) {
  return arguments.outlet.empty() || arguments.outlet == id;
}

void print_fault(const std::string& id, const std::string& fault) {
  std::printf("%-20s ! %s\n", id.c_str(), fault.c_str());
}

void print(const MonitorArguments& arguments, const link::OutletPresence& outlet) {
  if (!outlet.fault.empty()) {
    print_fault(outlet.id, outlet.fault);
  } else if (wanted(arguments, outlet.id)) {
    gs::wire::Uplink hello;
    hello.hello = outlet.hello;
    std::printf("%s\n", message_text(outlet.id, hello).c_str());
  }
}

void print(const MonitorArguments& arguments, const link::Happenings& happenings) {
  for (const link::OutletPresence& outlet : happenings.joined) {
    print(arguments, outlet);
  }
  for (const link::Received& received : happenings.messages) {
    const bool measurement = received.message.kind == gs::wire::UplinkKind::kMeasurement;
    if (wanted(arguments, received.id) && !(arguments.quiet && measurement)) {
      std::printf("%s\n", message_text(received.id, received.message).c_str());
    }
  }
  for (const std::vector<link::Fault>& faults : {happenings.left, happenings.faults}) {
    for (const link::Fault& fault : faults) {
      print_fault(fault.id, fault.what);
    }
  }
}

int monitor(const MonitorArguments& arguments) {
  const std::atomic<bool>& interrupted = catch_interrupts();
  const FoundOutlets found = find_outlets(arguments.link);
  if (std::none_of(found.outlets.begin(), found.outlets.end(), [&](const auto& outlet) {
        return outlet.fault.empty() && wanted(arguments, outlet.id);
      })) {
    throw profile::ConfigurationError(arguments.outlet.empty()
                                          ? "no outlet answers"
                                          : "no outlet " + arguments.outlet + " answers");
  }
  for (const link::OutletPresence& outlet : found.outlets) {
    print(arguments, outlet);
  }
  std::fflush(stdout);
  const auto started = std::chrono::steady_clock::now();
  link::Happenings happenings;
  while (!interrupted && !std::ferror(stdout) &&
         std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count() <
             arguments.seconds) {
    happenings.clear();
    const drivers::Status status = found.link->poll(happenings);
    if (!status.ok()) {
      throw std::runtime_error(status.error());
    }
    print(arguments, happenings);
    std::fflush(stdout);
    std::this_thread::sleep_for(kBetweenLooks);
  }
  // An interrupt is how one ends looking.
  return kPassed;
}

}  // namespace

void add_monitor(CommandLine& line) {
  auto arguments = std::make_shared<MonitorArguments>();
  const Command command = line.command("monitor", "Prints what outlets say, as they say it");
  add_link_options(command, arguments->link);
  command.option("--outlet", arguments->outlet, "Only this one's messages");
  command.option("--seconds", arguments->seconds, "End after so long; else at an interrupt")
      .positive();
  command.flag("--quiet", arguments->quiet, "Without the measurement of every 16 ms");
  command.footer(
      "Examples:\n"
      "  gsbench monitor --port /dev/ttyUSB0\n"
      "  gsbench monitor --station my-station.toml --outlet kitchen-1 --quiet");
  command.callback([arguments] { return monitor(*arguments); });
}

}  // namespace gsbench::cli
