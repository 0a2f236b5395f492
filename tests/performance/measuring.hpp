// Common code of the performance tests: exit with a reason, waiting, and figures with limits.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::performance {

// Prints the reason and exits with 1.
[[noreturn]] void die(const std::string& reason);

// Runs a shell command; exits if it fails.
void run_or_die(const char* command);

template <class T>
T or_die(drivers::Result<T> result) {
  if (!result.ok()) {
    die(result.error());
  }
  return result.take();
}

double seconds_since(std::chrono::steady_clock::time_point begin);

// Polls until the condition is true; false after one minute.
template <class Condition>
bool comes_true(Condition condition,
                std::chrono::microseconds pause = std::chrono::microseconds(20)) {
  const auto begin = std::chrono::steady_clock::now();
  while (!condition()) {
    if (seconds_since(begin) > 60.0) {
      return false;
    }
    std::this_thread::sleep_for(pause);
  }
  return true;
}

template <class Condition>
void wait_for(Condition condition, const char* reason) {
  if (!comes_true(condition)) {
    die(reason);
  }
}

double median(std::vector<double> values);

// Processor time of this process with all its threads, s.
double own_processor_s();

void print(const char* what, double value, const char* unit);

// Prints a figure with its limit.
void judge_at_least(const char* what, double value, const char* unit, double limit);
void judge_at_most(const char* what, double value, const char* unit, double limit);

// Return value of main(): 1 if a figure missed its limit.
int exit_code();

}  // namespace gsbench::performance
