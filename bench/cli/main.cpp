#include "commands.hpp"
#include "completion.hpp"
#include "manual_page.hpp"

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include <installation/installation.hpp>
#include <keys/document.hpp>
#include <profile/load.hpp>
#include <record/store.hpp>
#include <render/file.hpp>

namespace {

namespace cli = gsbench::cli;

constexpr const char* kAbout =
    "gsbench plays the frequency response of a power system into Grid Sense outlets, records\n"
    "what they measured, estimated and switched, and judges it.\n"
    "\n"
    "  gsbench run paper/loss-500mw        play, judge, report\n"
    "  gsbench list                        list profiles, grids and stations\n"
    "  gsbench params ieee24               threshold loss and settings for a grid\n";

constexpr const char* kExitCodes =
    "Exit codes: 0 PASS; 1 FAIL; 2 bad usage, bad file (profile, grid, station, recording,\n"
    "settings), or an output that cannot be written; 3 INCONCLUSIVE; 4 ERROR; 130 interrupted.";

void add_commands(cli::CommandLine& line) {
  for (const auto add :
       {cli::add_run, cli::add_list, cli::add_check, cli::add_params, cli::add_waveform,
        cli::add_report, cli::add_rejudge, cli::add_runs, cli::add_compare, cli::add_study,
        cli::add_reproduce, cli::add_fleet, cli::add_immunity, cli::add_measures, cli::add_schema,
        cli::add_devices, cli::add_monitor, cli::add_safe}) {
    add(line);
  }
}

std::string unknown_command(const CLI::App& app, const std::string& name) {
  return "unknown command '" + name + "'" +
         gsbench::keys::suggestion(name, cli::command_names(app), "commands");
}

std::string usage_mistake(const CLI::App* app, const CLI::Error& error) {
  const std::vector<CLI::App*> commands = app->get_subcommands();
  const std::vector<std::string> unknown = app->remaining(true);
  std::string what = commands.empty() ? "a command is required" : error.what();
  if (!unknown.empty()) {
    what = commands.empty() ? unknown_command(*app, unknown.front())
                            : "unknown argument '" + unknown.front() + "'";
  }
  const std::string command = commands.empty() ? "" : commands.front()->get_name() + ' ';
  return cli::error_line(what + "; see `gsbench " + command + "--help`");
}

int complain(const char* what, int exit_code) {
  cli::print_error(what);
  return exit_code;
}

// Prints candidates for a shell's completion, or the manual page, if asked for. Returns false for
// all other commands.
bool answer_installation(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || (words[0] != "__complete" && words[0] != "__manual")) {
    return false;
  }
  if (words[0] == "__manual") {
    std::fputs(cli::manual_page(app).c_str(), stdout);
  } else {
    for (const std::string& candidate : cli::completions(app, {words.begin() + 1, words.end()})) {
      std::puts(candidate.c_str());
    }
  }
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  // A file that reaches the limit for its size is then an error like a full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  cli::CommandLine line{CLI::App(kAbout, "gsbench")};
  line.app.formatter(cli::help_formatter());
  line.app.set_help_flag("-h,--help", "Print this help");
  line.app.footer(kExitCodes);
  line.app.set_version_flag("--version", "gsbench " + gsbench::installation::version(),
                            "Print the version");
  line.app.require_subcommand(1);
  line.app.failure_message(usage_mistake);
  add_commands(line);
  try {
    if (!answer_installation(line.app, {argv + 1, argv + argc})) {
      line.app.parse(argc, argv);
    }
  } catch (const CLI::ParseError& error) {
    line.exit_code = line.app.exit(error) == 0 ? cli::kPassed : cli::kBadInput;
  } catch (const gsbench::profile::ConfigurationError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const gsbench::record::StoreError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const gsbench::render::WriteError& error) {
    return complain(error.what(), cli::kBadInput);
  } catch (const std::bad_alloc&) {
    return complain("out of memory: use fewer outlets, a shorter run or fewer --threads",
                    cli::kErrored);
  } catch (const std::exception& error) {
    return complain(error.what(), cli::kErrored);
  }
  // Report output that was lost, for instance on a full disk.
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return complain("standard output cannot be written",
                    line.exit_code == cli::kErrored ? cli::kErrored : cli::kBadInput);
  }
  return line.exit_code;
}
