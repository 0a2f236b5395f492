// How the bytes of a recording are divided into cells, and what is in them.
#pragma once

#include "csv.hpp"
#include "instant.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <recording/trace.hpp>

namespace gsbench::recording {

class Dialect {
 public:
  // Throws FormatError if an option is not valid. `format` must outlive this.
  Dialect(const TraceFormat& format, double nominal_hz);

  char delimiter() const { return delimiter_; }
  std::size_t skip_rows() const { return skip_rows_; }
  std::size_t header_rows() const { return header_rows_; }

  std::optional<double> number(const std::string& text) const;
  std::optional<Instant> instant(const std::string& text) const;
  double frequency_hz(double value) const;
  bool is_gap(const std::string& text) const;

 private:
  const TraceFormat& format_;
  char delimiter_ = ',';
  std::size_t skip_rows_ = 0;
  std::size_t header_rows_ = 1;
  double time_unit_s_ = 1.0;
  double frequency_unit_hz_ = 1.0;
  std::vector<std::string> gaps_;  // in lower case
};

}  // namespace gsbench::recording
