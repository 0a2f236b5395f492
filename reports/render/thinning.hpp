// Selects the entries of a long series that a plot needs: the extremes of each interval. The
// thinned curve looks like the complete one, and no spike is lost.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::render {

struct Stretch {
  std::int64_t from_tick;
  std::int64_t to_tick;
};

// Indices of the entries to keep, ascending, at most `most`. `most` is at least 20. If the series
// has no more entries than that, all are kept. Otherwise these are kept:
// - the first and the last entry;
// - every entry within the stretches of `whole`, in their order, up to half of `most`;
// - from each of equal parts of the series, the minimum and maximum of both columns, and the first
//   NaN, so that gaps stay gaps.
std::vector<std::size_t> thinned(const std::vector<std::int64_t>& tick,
                                 const std::vector<double>& first,
                                 const std::vector<double>& second,
                                 const std::vector<Stretch>& whole, std::size_t most);

// Thins a trace while it is read: each hundredth of the run to 1200 entries. So no more are in
// memory than a hundredth has and 120 000. Nothing is left out of a run of up to half an hour.
template <class Trace>
class TraceThinning {
 public:
  using Column = std::vector<float> Trace::*;

  TraceThinning(std::int64_t run_ticks, const std::vector<Stretch>& whole, Column first,
                Column second)
      : part_ticks_(run_ticks / kParts + 1), whole_(whole), first_(first), second_(second) {}

  void add(const Trace& piece) {
    entries_ += piece.tick.size();
    for (std::size_t i = 0; i < piece.tick.size(); ++i) {
      const std::int64_t part = piece.tick[i] / part_ticks_;
      if (part != part_) {
        thin();
        part_ = part;
      }
      record::append(piece, i, in_part_);
    }
  }

  std::size_t entries() const { return entries_; }  // that were added

  // After the last piece.
  Trace take() {
    thin();
    return std::move(kept_);
  }

 private:
  static constexpr std::int64_t kParts = 100;
  static constexpr std::size_t kMostOfAPart = 1200;

  std::vector<double> column(Column of) const {
    return {(in_part_.*of).begin(), (in_part_.*of).end()};
  }

  void thin() {
    for (const std::size_t i :
         thinned(in_part_.tick, column(first_), column(second_), whole_, kMostOfAPart)) {
      record::append(in_part_, i, kept_);
    }
    in_part_ = {};
  }

  std::int64_t part_ticks_;
  const std::vector<Stretch>& whole_;
  Column first_;
  Column second_;
  std::int64_t part_ = 0;
  std::size_t entries_ = 0;
  Trace in_part_;
  Trace kept_;
};

}  // namespace gsbench::render
