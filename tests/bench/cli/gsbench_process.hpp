// Runs the gsbench program and collects what it leaves behind.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace gsbench::test {

struct Outcome {
  int exit_code = -1;  // 128 + the signal where one ended it
  std::string out;
  std::string err;
};

Outcome run_gsbench(const std::vector<std::string>& arguments);

// The same with no rights but everyone's; only root can do so.
Outcome run_gsbench_as_nobody(const std::vector<std::string>& arguments);

// The same where the process may take no more address space than this.
Outcome run_gsbench_within(std::uint64_t most_bytes, const std::vector<std::string>& arguments);

// The same, without waiting for its end.
struct Started {
  pid_t pid;
  std::filesystem::path out;
  std::filesystem::path err;
};
Started start_gsbench(const std::vector<std::string>& arguments);
Outcome wait_for(const Started& started);

std::string text_of(const std::filesystem::path& path);

// The only run kept in an output folder.
std::filesystem::path only_run(const std::filesystem::path& output_folder);

}  // namespace gsbench::test
