// Output to a reader that may stop reading, such as a pager, without waiting for it.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include <drivers/descriptor.hpp>

namespace gsbench::cli {

class PatientOutput {
 public:
  // Text that waits for the reader, at most.
  static constexpr std::size_t kRoom_bytes = std::size_t{1} << 20U;

  // `descriptor` stays open and as it is. `notice`: the line that states how many lines were left
  // out. A reader that is gone must not end the process: SIGPIPE is ignored from now on.
  PatientOutput(int descriptor, std::function<std::string(std::uint64_t)> notice);

  // Adds a line, without its end. If kRoom_bytes wait, it is left out and counted; once half of
  // them have been read, the notice follows in its place. Does not block.
  void put(const std::string& line);
  // Writes as much as the reader takes now. Does not block.
  void flush();
  // Writes all, and the notice of lines left out. Blocks while the reader reads, and for `patience`
  // after it has stopped.
  void finish(std::chrono::milliseconds patience);

  // The errno value that ended the output, EPIPE if the reader is gone; 0: none.
  int error() const { return error_; }
  bool writes_to_terminal() const { return is_terminal_; }

 private:
  std::size_t waiting_bytes() const { return waiting_.size() - written_; }
  int target() const { return own_.is_open() ? own_.get() : descriptor_; }
  bool takes_some(std::chrono::milliseconds patience) const;

  int descriptor_;
  drivers::Descriptor own_;  // the same pipe or terminal, opened without blocking
  bool is_terminal_;
  std::function<std::string(std::uint64_t)> notice_;
  std::string waiting_;
  std::size_t written_ = 0;  // of waiting_
  std::uint64_t left_out_ = 0;
  int error_ = 0;
};

}  // namespace gsbench::cli
