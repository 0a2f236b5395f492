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
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include <wire/messages.hpp>

namespace gsbench::cli {
namespace {

using std::chrono::duration;
using std::chrono::steady_clock;

constexpr auto kPollInterval = std::chrono::milliseconds(20);
constexpr double kUntilMissing_s = 3.0;  // then an outlet counts as missing; between looks, too
constexpr auto kForTheReader = std::chrono::seconds(1);
constexpr double kToAnswer_s = 1.0;  // an outlet answers within 0.5 s (wire/README.md, hello)
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

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

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
    if (output_.error() == 0) {
      show_missing(true);
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

  double seconds_passed() const { return duration<double>(steady_clock::now() - started_).count(); }

  // The exit code once the wait for the first answer has taken too long.
  std::optional<int> waited_in_vain() {
    const double passed_s = seconds_passed();
    if (passed_s >= next_look_s_) {
      show_missing(false);
      next_look_s_ = passed_s + kUntilMissing_s;
    }
    if (output_.has_answered() || passed_s < arguments_.wait_s) {
      return std::nullopt;
    }
    show_missing(true);
    output_.finish(kForTheReader);
    print_error(arguments_.outlet.empty()
                    ? fmt::format("no outlet answered within {:.3g} s", arguments_.wait_s)
                    : fmt::format("outlet \"{}\" did not answer within {:.3g} s", arguments_.outlet,
                                  arguments_.wait_s));
    return kErrored;
  }

  // Outlets that are expected or were heard, and have never joined, with the reason.
  std::map<std::string, std::string> missing() const {
    std::map<std::string, std::string> reasons;
    for (const link::Fault& fault : reached_.not_joined()) {
      reasons[fault.id] = fault.what;
    }
    for (const auto& names :
         {reached_.is_search ? std::vector<std::string>() : reached_.ports, reached_.ids}) {
      for (const std::string& name : names) {
        reasons.emplace(name, kSilent);
      }
    }
    for (auto it = reasons.begin(); it != reasons.end();) {
      it = output_.knows(it->first) ? reasons.erase(it) : std::next(it);
    }
    return reasons;
  }

  // Each reason once. Outlets that are named may still join, and others may come: at a later look,
  // one that was not there at the look before gets more time. The last look gives time only to
  // those that may still answer.
  void show_missing(bool last) {
    std::map<std::string, std::string> now = missing();
    for (const auto& [name, reason] : now) {
      const bool is_port = contains(reached_.ports, name);
      const bool has_had_time =
          looked_ ? seen_.count(name) > 0 : !last || seconds_passed() >= kToAnswer_s;
      const bool is_late = has_had_time || (last && reason != kSilent);
      if (is_late && shown_.insert({name, reason}).second) {
        output_.show_fault(is_port ? "" : name, is_port ? name : reached_.broker, reason);
      }
    }
    seen_ = std::move(now);
    if (!last && !looked_ && !output_.has_answered() && arguments_.wait_s > kUntilMissing_s) {
      output_.flush();
      print_error(fmt::format("waiting for {} on {}, {:.3g} s at most; Ctrl-C ends",
                              awaited(arguments_), reached_.places(), arguments_.wait_s));
    }
    looked_ = true;
  }

  int exit_code() const {
    // A reader that ends, such as `head`, is a usual way to stop, as Ctrl-C is.
    if (output_.error() == 0 || output_.error() == EPIPE) {
      return output_.has_fault() ? kErrored : kPassed;
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
  double next_look_s_ = std::min(kUntilMissing_s, arguments_.wait_s);
  bool looked_ = false;
  std::map<std::string, std::string> seen_;              // at the last look
  std::set<std::pair<std::string, std::string>> shown_;  // names with reasons
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
      "--json: each object has an \"event\". The first one has the \"format_version\", 1, too.\n"
      "  \"joined\": id, where, fault (empty: none), protocol, and the fields of the hello; "
      "arrival_s,\n"
      "    start_number, sample\n"
      "  \"message\": id, arrival_s, start_number, sequence, sample, kind, and the fields of this "
      "kind\n"
      "  \"left\": id, where, fault: the reason; it may join again\n"
      "  \"fault\": id, where (each if it is known), fault\n"
      "  \"left out\": count of objects left out\n"
      "arrival_s counts from the start of the command. \"sequence\" is counted apart for hellos.\n"
      "\n"
      "Exit code 4 if no outlet answers in time, or if at the end an outlet that is shown has one "
      "of\n"
      "the faults for which gsbench devices exits with 4; one that has left is no fault. A serial "
      "or "
      "TCP\n"
      "port is read by one bench at a time: exit code 4 if another bench uses it.\n"
      "\n"
      "Examples:\n"
      "  gsbench monitor --port /dev/ttyUSB0\n"
      "  gsbench monitor kitchen-1 --station my-station.toml --quiet\n"
      "  gsbench monitor --json | jq 'select(.kind == \"decision\")'");
}

}  // namespace gsbench::cli
