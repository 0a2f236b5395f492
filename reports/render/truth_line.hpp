// The true frequency between the entries of a record.
#pragma once

#include <record/run_record.hpp>

namespace gsbench::render {

// Straight lines between entries; NaN before the first and after the last. Ticks must not descend
// from call to call (one pass over the truth for one pass over an outlet's reports).
class TruthLine {
 public:
  explicit TruthLine(const record::TruthTrace& truth) : truth_(truth) {}
  double frequency_hz(std::int64_t tick);

 private:
  const record::TruthTrace& truth_;
  std::size_t next_ = 0;  // first entry after the last tick asked for
};

}  // namespace gsbench::render
