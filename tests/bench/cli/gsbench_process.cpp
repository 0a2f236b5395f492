#include "gsbench_process.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <sstream>
#include <stdexcept>

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

// `prepare` is called in the new process.
template <class Prepare>
Started start(const std::vector<std::string>& arguments, Prepare prepare) {
  Started started{-1, new_file(), new_file()};
  std::vector<std::string> words = {GSBENCH_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) {
    argv.push_back(word.data());
  }
  argv.push_back(nullptr);
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

}  // namespace

std::string text_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

Started start_gsbench(const std::vector<std::string>& arguments) {
  return start(arguments, [] {});
}

Outcome wait_for(const Started& started) {
  int status = 0;
  waitpid(started.pid, &status, 0);
  Outcome outcome;
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  outcome.out = text_of(started.out);
  outcome.err = text_of(started.err);
  fs::remove(started.out);
  fs::remove(started.err);
  return outcome;
}

Outcome run_gsbench(const std::vector<std::string>& arguments) {
  return wait_for(start_gsbench(arguments));
}

Outcome run_gsbench_as_nobody(const std::vector<std::string>& arguments) {
  return wait_for(start(arguments, [] {
    constexpr uid_t kNobody = 65534;
    if (setgid(kNobody) != 0 || setuid(kNobody) != 0) {
      _exit(127);
    }
  }));
}

Outcome run_gsbench_within(std::uint64_t most_bytes, const std::vector<std::string>& arguments) {
  return wait_for(start(arguments, [&] {
    const rlimit limit{most_bytes, most_bytes};
    if (setrlimit(RLIMIT_AS, &limit) != 0) {
      _exit(127);
    }
  }));
}

fs::path only_run(const fs::path& output_folder) {
  fs::path run;
  for (const fs::directory_entry& entry : fs::directory_iterator(output_folder)) {
    if (!run.empty()) {
      throw std::runtime_error("more than one run in " + output_folder.string());
    }
    run = entry.path();
  }
  if (run.empty()) {
    throw std::runtime_error("no run in " + output_folder.string());
  }
  return run;
}

}  // namespace gsbench::test
