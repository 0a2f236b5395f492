#include "gsbench_process.hpp"

#include <fcntl.h>
#include <pty.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <test_support/waiting.hpp>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <fstream>
#include <regex>
#include <sstream>
#include <stdexcept>

#include <gmock/gmock.h>

#include <render/layout.hpp>

namespace gsbench::test {

namespace fs = std::filesystem;

namespace {

fs::path new_file() {
  static std::atomic<int> count{0};
  return fs::temp_directory_path() /
         ("gsbench-output-" + std::to_string(getpid()) + "-" + std::to_string(count++));
}

void redirect(const fs::path& path, int descriptor) {
  const int file = open(path.c_str(), O_CREAT | O_TRUNC | O_WRONLY, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) {
    _exit(127);
  }
  close(file);
}

Outcome wait_for(const Started& started) {
  int status = 0;
  rusage used{};
  wait4(started.pid, &status, 0, &used);
  Outcome outcome;
  outcome.peak_memory_mb = static_cast<double>(used.ru_maxrss) * 1024.0 / 1e6;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = text_of(started.out);
  outcome.err = text_of(started.err);
  fs::remove(started.out);
  fs::remove(started.err);
  return outcome;
}

// The arguments of an execv() of gsbench, which point into `words`.
std::vector<char*> argv_of(Words& words) {
  words.insert(words.begin(), GSBENCH_PROGRAM);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
  return argv;
}

}  // namespace

Started start_gsbench(const Words& arguments, const std::function<void()>& prepare) {
  Started started{-1, new_file(), new_file()};
  Words words = arguments;
  const std::vector<char*> argv = argv_of(words);
  started.pid = fork();
  if (started.pid < 0) {
    throw std::runtime_error("fork failed");
  }
  if (started.pid == 0) {
    redirect(started.out, STDOUT_FILENO);
    redirect(started.err, STDERR_FILENO);
    prepare();
    execv(argv[0], argv.data());
    _exit(127);
  }
  return started;
}

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Outcome stop(const Started& started, int signal) {
  kill(started.pid, signal);
  return wait_for(started);
}

Outcome run_gsbench(const Words& arguments, const std::function<void()>& prepare) {
  return wait_for(start_gsbench(arguments, prepare));
}

std::string run_on_terminal(const Words& arguments) {
  Words words = arguments;
  const std::vector<char*> argv = argv_of(words);
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, nullptr);
  if (child < 0) {
    throw std::runtime_error("forkpty failed");
  }
  if (child == 0) {
    execv(argv[0], argv.data());
    _exit(127);
  }
  std::string text;
  char buffer[4096];
  // At the end of the child read() fails with EIO.
  for (ssize_t count = 0; (count = read(terminal, buffer, sizeof buffer)) > 0;) {
    text.append(buffer, static_cast<std::size_t>(count));
  }
  close(terminal);
  waitpid(child, nullptr, 0);
  static const std::regex unseen("\x1b\\[[0-9;]*[A-Za-z]|\r");
  return std::regex_replace(text, unseen, "");
}

json run_for_json(const Words& arguments) {
  const Outcome outcome = run_gsbench(arguments);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err << outcome.out;
  return json::parse(outcome.out);
}

void expect_refused(const Words& arguments, const std::string& message) {
  const Outcome outcome = run_gsbench(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments);
  EXPECT_THAT(outcome.err, testing::HasSubstr(message)) << testing::PrintToString(arguments);
}

Outcome interrupted(const Words& arguments, long hundredths) {
  const Started started = start_gsbench(arguments);
  EXPECT_TRUE(until([&] {
    std::ifstream stat("/proc/" + std::to_string(started.pid) + "/stat");
    std::string field;
    // Field 14: time in user mode, in hundredths of a second.
    for (int i = 0; i < 14; ++i) {
      stat >> field;
    }
    return stat && std::stol(field) >= hundredths;
  })) << "it uses no processor time";
  Outcome outcome = stop(started, SIGINT);
  EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
  return outcome;
}

void expect_lines_within_100_columns(const Words& arguments) {
  const Outcome outcome = run_gsbench(arguments);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(render::columns_of(line), 100U) << line;
  }
}

fs::path only_run(const fs::path& output_folder) {
  const std::vector<fs::directory_entry> runs(fs::directory_iterator(output_folder), {});
  if (runs.size() != 1) {
    throw std::runtime_error(std::to_string(runs.size()) + " runs in " + output_folder.string());
  }
  return runs.front().path();
}

}  // namespace gsbench::test
