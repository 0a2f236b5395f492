// A line on the terminal with the progress of long work and its remaining time. Nothing is printed
// for work of less than two seconds. A text is shown from half a second on. If standard error is
// not a terminal, only texts are printed, after two seconds and then every ten, each as a line.
#pragma once

#include <chrono>
#include <string>

namespace gsbench::cli {

class Progress {
 public:
  explicit Progress(const std::string& what);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void show(double part);              // 0 … 1; prints at most ten times per second
  void show(const std::string& what);  // of work without a known part, as often
  void clear();                        // the line, before other text is printed

 private:
  void print(const std::string& line);

  std::string what_;
  bool terminal_;
  bool drawn_ = false;
  int lines_ = 0;  // on a pipe
  std::chrono::steady_clock::time_point started_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace gsbench::cli
