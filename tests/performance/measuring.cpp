#include "measuring.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>

namespace gsbench::performance {

namespace {

bool short_of = false;

void judge(const char* what, double value, const char* unit, bool reached, const char* side,
           double wanted) {
  short_of = short_of || !reached;
  std::printf("%-62s %12.3f %-12s wanted %s %g: %s\n", what, value, unit, side, wanted,
              reached ? "reached" : "FALLS SHORT");
}

}  // namespace

void die(const std::string& why) {
  std::fprintf(stderr, "%s\n", why.c_str());
  std::exit(1);
}

void run_or_die(const char* command) {
  if (std::system(command) != 0) {
    die(std::string("this failed: ") + command);
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

void judge_at_least(const char* what, double value, const char* unit, double wanted) {
  judge(what, value, unit, value >= wanted, "at least", wanted);
}

void judge_at_most(const char* what, double value, const char* unit, double wanted) {
  judge(what, value, unit, value <= wanted, "at most", wanted);
}

int exit_code() {
  return short_of ? 1 : 0;
}

}  // namespace gsbench::performance
