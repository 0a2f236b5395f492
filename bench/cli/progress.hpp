// One line on a terminal that says how far a long work is and how long it will still take. Silent
// where standard error is no terminal, and for work that is over within two seconds.
#pragma once

#include <chrono>
#include <string>

namespace gsbench::cli {

class Progress {
 public:
  explicit Progress(std::string what);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double part);  // 0 … 1; draws at most ten times a second

 private:
  std::string what_;
  bool terminal_;
  bool drawn_ = false;
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace gsbench::cli
