#include <algorithm>
#include <utility>

#include <judge/catalogue.hpp>

namespace gsbench::judge {
namespace {

std::vector<Measure> all_measures() {
  std::vector<Measure> all;
  for (std::vector<Measure> part : {tracker_measures(), event_measures(), estimate_measures(),
                                    relay_measures(), clock_measures()}) {
    std::move(part.begin(), part.end(), std::back_inserter(all));
  }
  return all;
}

}  // namespace

const std::vector<Measure>& catalogue() {
  static const std::vector<Measure> all = all_measures();
  return all;
}

const Measure* find_measure(const std::string& name) {
  const auto found = std::find_if(catalogue().begin(), catalogue().end(),
                                  [&](const Measure& measure) { return measure.name == name; });
  return found == catalogue().end() ? nullptr : &*found;
}

profile::MeasureCatalogue measure_names() {
  profile::MeasureCatalogue names;
  for (const Measure& measure : catalogue()) {
    names.push_back({measure.name, measure.unit, measure.is_word(), measure.words});
  }
  return names;
}

Reading number(double value, double uncertainty) {
  Reading reading;
  reading.value = value;
  reading.uncertainty = uncertainty;
  return reading;
}

Reading word(std::string text) {
  Reading reading;
  reading.word = std::move(text);
  return reading;
}

Reading not_done(std::string why) {
  Reading reading;
  reading.missing = std::move(why);
  return reading;
}

Reading not_known(std::string why) {
  Reading reading;
  reading.missing = std::move(why);
  reading.outlets_fault = false;
  return reading;
}

}  // namespace gsbench::judge
