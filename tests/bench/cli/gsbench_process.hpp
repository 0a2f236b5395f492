// Runs the gsbench program and collects its output and exit code.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace gsbench::test {

using nlohmann::json;

struct Outcome {
  int exit_code = -1;  // 128 + number of the signal that ended it
  std::string out;
  std::string err;
  double peak_memory_mb = 0.0;  // the largest resident set
};

using Words = std::vector<std::string>;

// `prepare` is called in the new process before the program starts.
Outcome run_gsbench(
    const Words& arguments, const std::function<void()>& prepare = [] {});

// Everything that gsbench prints with a pseudo-terminal as standard output and standard error,
// without colours and carriage returns.
std::string run_on_terminal(const Words& arguments);

// Its output, parsed as JSON; a test failure unless it exits with 0.
json run_for_json(const Words& arguments);

// A test failure unless it exits with 2 and a message that contains `message`.
void expect_refused(const Words& arguments, const std::string& message);

// Started, without waiting for its end.
struct Started {
  pid_t pid;
  std::filesystem::path out;
  std::filesystem::path err;
};
Started start_gsbench(
    const Words& arguments, const std::function<void()>& prepare = [] {});
Outcome stop(const Started& started, int signal);

// Interrupts the process when it has used so much processor time, in hundredths of a second, so
// that it is past its start. A test failure unless it exits with 130.
Outcome interrupted(const Words& arguments, long hundredths = 30);

// A test failure unless it exits with 0 and no line has more than 100 columns.
void expect_lines_within_100_columns(const Words& arguments);

std::string text_of(const std::filesystem::path& path);

// The folder of the only run in an output folder. Throws std::runtime_error for another number.
std::filesystem::path only_run(const std::filesystem::path& output_folder);

}  // namespace gsbench::test
