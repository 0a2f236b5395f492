// Runs the gsbench program and collects what it leaves behind.
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
  int exit_code = -1;  // 128 + the signal where one ended it
  std::string out;
  std::string err;
};

using Words = std::vector<std::string>;

// `prepare` is called in the new process, before the program.
Outcome run_gsbench(
    const Words& arguments, const std::function<void()>& prepare = [] {});

// Everything that gsbench prints with a pseudo-terminal as standard output and standard error, without
// colours and carriage returns.
std::string run_on_terminal(const Words& arguments);

// What it prints for scripts; a failure where it does not exit with 0.
json run_for_json(const Words& arguments);

// A failure where it does not exit with 2 and a message that has `says`.
void expect_refused(const Words& arguments, const std::string& says);

// The same, without waiting for its end.
struct Started {
  pid_t pid;
  std::filesystem::path out;
  std::filesystem::path err;
};
Started start_gsbench(
    const Words& arguments, const std::function<void()>& prepare = [] {});
Outcome stop(const Started& started, int signal);

std::string text_of(const std::filesystem::path& path);

// The only run kept in an output folder.
std::filesystem::path only_run(const std::filesystem::path& output_folder);

}  // namespace gsbench::test
