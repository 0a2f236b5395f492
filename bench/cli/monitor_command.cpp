#include "commands.hpp"
#include "link_arguments.hpp"
#include "live_output.hpp"
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <limits>
#include <thread>

#include <fmt/format.h>

#include <link/version_text.hpp>
#include <wire/messages.hpp>

namespace gsbench::cli {
namespace {

using gs::wire::Uplink;
using gs::wire::UplinkKind;

const char* validity_text(gs::outlet::Validity validity) {
  static constexpr std::array kNames = {"invalid", "valid", "held"};
  const auto index = static_cast<std::size_t>(validity);
  return index < kNames.size() ? kNames[index] : "unknown";
}

const char* position(bool closed) {
  return closed ? "closed" : "open";
}

std::string hello_text(const gs::wire::Hello& hello) {
  return fmt::format("board {}, firmware {} build {:08x}, {} Hz samples of {} Hz mains, {}",
                     hello.board, link::version_text(hello.firmware_version), hello.build,
                     hello.sample_rate_hz, hello.nominal_hz,
                     hello.settings_version == 0
                         ? std::string("no settings")
                         : fmt::format("settings version {}", hello.settings_version));
}

std::string details(const Uplink& m) {
  switch (m.kind) {
    case UplinkKind::kHello:
      return hello_text(m.hello);
    case UplinkKind::kSettingsAnswer:
      return fmt::format("{}; in force: version {}, digest {:08x}{}",
                         gs::outlet::to_string(m.settings_answer.error), m.settings_answer.version,
                         m.settings_answer.digest, m.settings_answer.kept ? ", kept" : "");
    case UplinkKind::kMeasurement:
      return fmt::format("{:9.4f} Hz {:+8.3f} Hz/s {:6.4f} pu {}", m.measurement.frequency_hz,
                         m.measurement.rocof_hz_s, m.measurement.voltage_pu,
                         validity_text(m.measurement.validity));
    case UplinkKind::kEvent:
      return fmt::format("from {:.4f} Hz, {:+.4f} Hz/s", m.event.baseline_hz,
                         m.event.baseline_rocof_hz_s);
    case UplinkKind::kLse:
      return fmt::format("{:.1f} MW", m.lse.loss_mw);
    case UplinkKind::kEstimate:
      return fmt::format("{:.1f} ± {:.1f} MW, {}", m.estimate.loss_mw, m.estimate.loss_sigma_mw,
                         gs::outlet::to_string(m.estimate.trust));
    case UplinkKind::kDecision:
      return fmt::format(
          "{}: {:.1f} ± {:.1f} MW lost, nadir {:.3f} Hz, {:.1f} MW to shed after {:.1f} MW before, "
          "{} hits, estimate {}",
          m.decision.shed ? "shed" : "hold", m.decision.loss_mw, m.decision.loss_sigma_mw,
          m.decision.nadir_hz, m.decision.required_mw, m.decision.shed_before_mw, m.decision.hits,
          gs::outlet::to_string(m.decision.trust));
    case UplinkKind::kRelay:
      return fmt::format("{}, cause {}", position(m.relay.closed),
                         gs::outlet::to_string(m.relay.cause));
    case UplinkKind::kAborted:
      return "the voltage was lost";
    case UplinkKind::kCommandAnswer:
      return fmt::format("request {}: relay {}", m.command_answer.request,
                         position(m.command_answer.closed));
    case UplinkKind::kStatus:
      return fmt::format("{} reports, relay {}, {} samples lost, {} messages bad, {} unsent",
                         m.status.reports, position(m.status.relay_closed), m.status.samples_lost,
                         m.status.messages_bad, m.status.messages_unsent);
    case UplinkKind::kSelfTest:
      return m.self_test.failed == 0
                 ? fmt::format("passed, fingerprint {:08x}", m.self_test.fingerprint)
                 : fmt::format("FAILED, parts {:#x}", m.self_test.failed);
    case UplinkKind::kEcho:
      return fmt::format("token {}", m.echo.token);
    case UplinkKind::kError:
      return fmt::format("{}, {} so far", gs::wire::to_string(m.error.code), m.error.detail);
  }
  return {};
}

// On a terminal a long line is wrapped; otherwise a line holds one message, so that scripts can
// filter them.
void print_line(const std::string& line) {
  constexpr std::size_t kIndent = 33;
  static const bool terminal = isatty(STDOUT_FILENO) == 1;
  if (terminal) {
    print_wrapped(line, kIndent);
  } else {
    std::puts(line.c_str());
  }
}

void print_message(const std::string& outlet, const Uplink& message) {
  print_line(fmt::format("{:<20} {:>10}  {:<15} {}", outlet, message.sample,
                         gs::wire::to_string(message.kind), details(message)));
}

constexpr auto kPollInterval = std::chrono::milliseconds(20);

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
  print_line(fmt::format("{:<20} ! {}", id, fault));
}

void print(const MonitorArguments& arguments, const link::OutletPresence& outlet) {
  if (!outlet.fault.empty()) {
    print_fault(outlet.id, outlet.fault);
  } else if (wanted(arguments, outlet.id)) {
    gs::wire::Uplink hello;
    hello.hello = outlet.hello;
    print_message(outlet.id, hello);
  }
}

void print(const MonitorArguments& arguments, const link::Happenings& happenings) {
  for (const link::OutletPresence& outlet : happenings.joined) {
    print(arguments, outlet);
  }
  for (const link::Received& received : happenings.messages) {
    const bool measurement = received.message.kind == gs::wire::UplinkKind::kMeasurement;
    if (wanted(arguments, received.id) && !(arguments.quiet && measurement)) {
      print_message(received.id, received.message);
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
  const FoundOutlets found = find_outlets(arguments.link, "monitor");
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
    std::this_thread::sleep_for(kPollInterval);
  }
  // Ctrl-C is the usual way to stop.
  return kPassed;
}

}  // namespace

void add_monitor(CommandLine& line) {
  const auto [command, arguments] =
      line.command("monitor", "Print the messages of outlets as they arrive", monitor);
  add_link_options(command, arguments.link);
  command.add_option("--outlet", arguments.outlet, "Print only this outlet's messages")
      ->type_name("ID");
  command
      .add_option("--seconds", arguments.seconds,
                  "Stop after S seconds (default: run until Ctrl-C)")
      ->type_name("S")
      ->check(CLI::PositiveNumber);
  command.add_flag("--quiet", arguments.quiet,
                   "Leave out the measurements, which come every 16 ms");
  command.footer(
      "A serial or TCP port is read by one bench at a time: exit code 4 if another bench uses it.\n"
      "\n"
      "Examples:\n"
      "  gsbench monitor --port /dev/ttyUSB0\n"
      "  gsbench monitor --station my-station.toml --outlet kitchen-1 --quiet");
}

}  // namespace gsbench::cli
