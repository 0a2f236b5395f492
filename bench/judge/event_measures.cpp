#include <algorithm>

#include <judge/reading.hpp>

namespace gsbench::judge {
namespace {

// An event is justified if the reference, at the event, is below its highest value of the half
// second before by at least half of the outlet's threshold.
constexpr double kLookStep_s = 0.016;
constexpr int kLookSteps = 31;

bool is_false(const Case& c, const record::Mark& event, double event_drop_hz) {
  const double end_s = std::max(c.seconds(event.tick) - c.tracker_delay_s(), 0.0);
  const double end_hz = c.reference.frequency_hz(end_s);
  double highest_hz = end_hz;
  for (int step = 1; step <= kLookSteps; ++step) {
    const double before_s = std::max(end_s - step * kLookStep_s, 0.0);
    highest_hz = std::max(highest_hz, c.reference.frequency_hz(before_s));
  }
  return highest_hz - end_hz < 0.5 * event_drop_hz;
}

Reading count(const Case& c) {
  return number(static_cast<double>(
      std::count_if(c.outlet.reports.marks.begin(), c.outlet.reports.marks.end(),
                    [](const record::Mark& mark) { return mark.kind == "event"; })));
}

Reading false_events(const Case& c) {
  const auto setting = c.outlet.settings.find("event_drop_hz");
  if (setting == c.outlet.settings.end()) {
    return not_known("the record does not contain the outlet's setting event_drop_hz");
  }
  return number(static_cast<double>(std::count_if(
      c.outlet.reports.marks.begin(), c.outlet.reports.marks.end(), [&](const record::Mark& mark) {
        return mark.kind == "event" && is_false(c, mark, setting->second);
      })));
}

Reading event_delay(const Case& c, std::int64_t loss_tick) {
  return stamped_after(c, loss_tick, c.first_mark("event", loss_tick),
                       "the outlet reported no event after the loss");
}

Reading hits(const Case& c) {
  const record::Mark* mark = c.first_mark("decision.hits");
  return mark == nullptr ? not_done("the outlet reported no decision") : number(mark->value);
}

}  // namespace

Readings event_readings() {
  return {
      {"event.count", count},
      {"event.false", false_events},
      {"event.delay", after_loss<event_delay>},
      {"condition.hits", hits},
  };
}

}  // namespace gsbench::judge
