#include "measuring.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace gsbench::performance {

namespace {

bool any_missed = false;

void judge(const char* what, double value, const char* unit, bool reached, const char* side,
           double limit) {
  any_missed = any_missed || !reached;
  std::printf("%-62s %12.3f %-12s limit: %s %g: %s\n", what, value, unit, side, limit,
              reached ? "met" : "MISSED");
}

}  // namespace

void die(const std::string& reason) {
  std::fprintf(stderr, "%s\n", reason.c_str());
  std::exit(1);
}

void run_or_die(const char* command) {
  if (std::system(command) != 0) {
    die(std::string("command failed: ") + command);
  }
}

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double own_processor_s() {
  timespec used{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

void print(const char* what, double value, const char* unit) {
  std::printf("%-62s %12.3f %s\n", what, value, unit);
}

void judge_at_least(const char* what, double value, const char* unit, double limit) {
  judge(what, value, unit, value >= limit, "at least", limit);
}

void judge_at_most(const char* what, double value, const char* unit, double limit) {
  judge(what, value, unit, value <= limit, "at most", limit);
}

int exit_code() {
  return any_missed ? 1 : 0;
}

}  // namespace gsbench::performance
