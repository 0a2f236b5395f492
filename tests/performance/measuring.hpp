// What the speed measurements share: an end that says why, waiting, and figures beside what is
// wanted of them.
#pragma once

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include <drivers/result.hpp>

namespace gsbench::performance {

[[noreturn]] void die(const std::string& why);

// A command of the shell, which must succeed.
void run_or_die(const char* command);

template <class T>
T or_die(drivers::Result<T> result) {
  if (!result.ok()) {
    die(result.error());
  }
  return result.take();
}

double seconds_since(std::chrono::steady_clock::time_point begin);

// Looks again after each pause; false after a minute.
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
void wait_for(Condition condition, const char* otherwise) {
  if (!comes_true(condition)) {
    die(otherwise);
  }
}

double median(std::vector<double> values);

// Of this process, all its threads.
double own_processor_s();

void print(const char* what, double value, const char* unit);

// A figure that is wanted to be so much at least, or at most.
void judge_at_least(const char* what, double value, const char* unit, double wanted);
void judge_at_most(const char* what, double value, const char* unit, double wanted);

// 1 where a figure fell short: what main() returns.
int exit_code();

}  // namespace gsbench::performance
