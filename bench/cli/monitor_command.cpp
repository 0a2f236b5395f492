#include "commands.hpp"
#include "link_arguments.hpp"
#include "live_output.hpp"
#include "message_text.hpp"
#include "monitor_output.hpp"
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <thread>

#include <fmt/format.h>

#include <wire/messages.hpp>

namespace gsbench::cli {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr auto kPollInterval = std::chrono::milliseconds(20);
constexpr double kUntilMissing_s = 3.0;  // then an outlet counts as missing
constexpr auto kForTheReader = std::chrono::seconds(1);
constexpr const char* kSilent = "does not answer";
constexpr double kLongest_s = 1e6;

struct MonitorArguments {
  LinkArguments link;
  std::string outlet;
  double seconds = std::numeric_limits<double>::infinity();
  double wait_s = 30.0;
  bool quiet = false;
  bool json = false;
};

std::string awaited(const MonitorArguments& arguments) {
  return arguments.outlet.empty() ? "an outlet" : "outlet " + arguments.outlet;
}

class Monitor {
 public:
  explicit Monitor(const MonitorArguments& arguments)
      : arguments_(arguments),
        reached_(reach_outlets(arguments.link, "monitor")),
        output_(STDOUT_FILENO, arguments.json, arguments.quiet, arguments.outlet) {}

  int run(const std::atomic<bool>& interrupted) {
    require(reached_.link->open());
    for (const link::OutletPresence& port : reached_.in_use) {
      output_.show_fault("", port.where, port.fault);
    }
    if (reached_.ports.empty() && reached_.broker.empty()) {
      output_.finish(kForTheReader);
      print_error("other benches use all ports");
      return kErrored;
    }
    while (!interrupted && output_.error() == 0 && !is_over()) {
      happenings_.clear();
      require(reached_.link->poll(happenings_));
      output_.show(happenings_);
      output_.flush();
      if (const auto given_up = waited_in_vain()) {
        return *given_up;
      }
      std::this_thread::sleep_for(kPollInterval);
    }
    reached_.link->close();
    output_.finish(kForTheReader);
    return exit_code();
  }

 private:
  static void require(const drivers::Status& done) {
    if (!done.ok()) {
      throw std::runtime_error(done.error());
    }
  }

  // --seconds counts from the first answer.
  bool is_over() {
    if (!answered_ && output_.has_answered()) {
      answered_ = steady_clock::now();
    }
    return answered_ &&
           duration<double>(steady_clock::now() - *answered_).count() >= arguments_.seconds;
  }

  // The exit code once the wait for the first answer has taken too long.
  std::optional<int> waited_in_vain() {
    const double passed_s = duration<double>(steady_clock::now() - started_).count();
    if (!missing_shown_ && passed_s >= std::min(kUntilMissing_s, arguments_.wait_s)) {
      missing_shown_ = true;
      show_missing();
    }
    if (output_.has_answered() || passed_s < arguments_.wait_s) {
      return std::nullopt;
    }
    output_.finish(kForTheReader);
    print_error(
        fmt::format("{} answered within {:.3g} s",
                    arguments_.outlet.empty() ? "no outlet" : "no outlet " + arguments_.outlet,
                    arguments_.wait_s));
    return kErrored;
  }

  // Outlets that are named may still join; so may others.
  void show_missing() {
    std::map<std::string, std::string> reasons;
    for (const link::Fault& fault : reached_.link->missing()) {
      reasons[fault.id] = fault.what;
    }
    for (const std::string& port : reached_.ports) {
      const auto reason = reasons.find(port);
      if (!reached_.is_search && !output_.knows(port)) {
        output_.show_fault("", port, reason != reasons.end() ? reason->second : kSilent);
      }
      reasons.erase(port);
    }
    for (const std::string& id : reached_.ids) {
      if (!output_.knows(id)) {
        reasons.emplace(id, kSilent);
      }
    }
    for (const auto& [id, reason] : reasons) {
      output_.show_fault(id, reached_.broker, reason);
    }
    if (!output_.has_answered() && arguments_.wait_s > kUntilMissing_s) {
      output_.flush();
      print_error(fmt::format("waiting for {} on {}, {:.3g} s at most; Ctrl-C ends",
                              awaited(arguments_), reached_.places(), arguments_.wait_s));
    }
  }

  int exit_code() const {
    // A reader that ends, such as `head`, is a usual way to stop, as Ctrl-C is.
    if (output_.error() == 0 || output_.error() == EPIPE) {
      return kPassed;
    }
    print_error(
        fmt::format("standard output cannot be written: {}", std::strerror(output_.error())));
    return kBadInput;
  }

  const MonitorArguments& arguments_;
  ReachableOutlets reached_;
  MonitorOutput output_;
  link::Happenings happenings_;
  const steady_clock::time_point started_ = steady_clock::now();
  std::optional<steady_clock::time_point> answered_;
  bool missing_shown_ = false;
};

// For check().
CLI::Validator outlet_id() {
  return CLI::Validator(
      [](std::string& text) {
        gs::wire::Hello hello;
        hello.protocol_version = 0;  // only the id is checked
        const bool fits = text.size() <= gs::wire::kLongestId;
        text.copy(hello.id, gs::wire::kLongestId);
        return fits && gs::wire::is_valid(hello)
                   ? std::string()
                   : text +
                         " is not the id of an outlet: 1 to 32 letters, digits, '-', '_' and "
                         "'.'; a port is given by --port";
      },
      "");
}

int monitor(const MonitorArguments& arguments) {
  return Monitor(arguments).run(catch_interrupts());
}

}  // namespace

void add_monitor(CommandLine& line) {
  const auto [command, arguments] =
      line.command("monitor", "Print the messages of outlets as they arrive", monitor);
  constexpr const char* kOnly = "Print only this outlet's messages";
  CLI::Option* const by_name =
      command.add_option("ID", arguments.outlet, kOnly)->type_name("ID")->check(outlet_id());
  command.add_option("--outlet", arguments.outlet, kOnly)
      ->type_name("ID")
      ->check(outlet_id())
      ->excludes(by_name);
  add_link_options(command, arguments.link);
  add_with_default(command, "--wait", arguments.wait_s, "S",
                   "Wait so long for this outlet, or else for the first one, 0.1 to 1000000 s")
      ->check(number_between(0.1, kLongest_s));
  command
      .add_option(
          "--seconds", arguments.seconds,
          "Stop S seconds after the first answer, 0.001 to 1000000 s (default: run until Ctrl-C)")
      ->type_name("S")
      ->check(number_between(0.001, kLongest_s));
  command.add_flag("--quiet", arguments.quiet,
                   "Leave out the measurements, which come every 16 ms");
  command.add_flag("--json", arguments.json, "Print JSON: one object on each line, at once");
  command.footer(
      "Outlets that join later are shown, too. If the reader of a pipe or a terminal stops, up to\n"
      "1 MiB waits for it; what is left out then is counted, and the count is shown.\n"
      "\n"
      "--json: each object has an \"event\": \"joined\" and \"message\" with the fields, \"left\" "
      "and\n"
      "\"fault\" with the reason, \"left out\" with the number of objects left out.\n"
      "\n"
      "Exit code 4 if no outlet answers in time. A serial or TCP port is read by one bench at a\n"
      "time: exit code 4 if another bench uses it.\n"
      "\n"
      "Examples:\n"
      "  gsbench monitor --port /dev/ttyUSB0\n"
      "  gsbench monitor kitchen-1 --station my-station.toml --quiet\n"
      "  gsbench monitor --json | jq 'select(.kind == \"decision\")'");
}

}  // namespace gsbench::cli
