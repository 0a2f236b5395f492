#include "truth_line.hpp"

#include <limits>

namespace gsbench::render {

double TruthLine::frequency_hz(std::int64_t tick) {
  while (next_ < truth_.tick.size() && truth_.tick[next_] <= tick) ++next_;
  if (next_ == 0) return std::numeric_limits<double>::quiet_NaN();
  const std::size_t before = next_ - 1;
  if (truth_.tick[before] == tick) return truth_.frequency_hz[before];
  if (next_ == truth_.tick.size()) return std::numeric_limits<double>::quiet_NaN();
  const double share = static_cast<double>(tick - truth_.tick[before]) /
                       static_cast<double>(truth_.tick[next_] - truth_.tick[before]);
  return truth_.frequency_hz[before] +
         share * (truth_.frequency_hz[next_] - truth_.frequency_hz[before]);
}

}  // namespace gsbench::render
