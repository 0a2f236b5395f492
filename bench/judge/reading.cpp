#include <algorithm>
#include <iterator>
#include <stdexcept>
#include <utility>

#include <judge/reading.hpp>

namespace gsbench::judge {

Readings all_readings() {
  Readings all;
  for (Readings part : {tracker_readings(), event_readings(), estimate_readings(),
                        contact_readings(), relay_readings(), clock_readings()}) {
    std::move(part.begin(), part.end(), std::back_inserter(all));
  }
  return all;
}

Read reading_of(const std::string& measure) {
  static const Readings all = all_readings();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& row) { return row.first == measure; });
  if (found == all.end()) {
    throw std::logic_error("no function reads the measure " + measure);
  }
  return found->second;
}

Reading number(double value, double uncertainty) {
  return {value, "", uncertainty};
}

Reading stamped_after(const Case& c, std::int64_t loss_tick, const record::Mark* mark,
                      std::string missing) {
  return mark == nullptr
             ? not_done(std::move(missing))
             : number(c.milliseconds_between(loss_tick, mark->tick), c.outlet.clock.uncertainty_ms);
}

Reading text(std::string value) {
  return {kNone, std::move(value)};
}

Reading not_done(std::string reason) {
  return {kNone, "", 0.0, std::move(reason)};
}

Reading not_known(std::string reason) {
  return {kNone, "", 0.0, std::move(reason), false};
}

}  // namespace gsbench::judge
