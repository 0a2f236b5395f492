// A catalogue of measures for tests, with the names and units that the shipped profiles rely on.
#pragma once

#include <profile/load.hpp>

namespace gsbench::profile::test {

inline const MeasureCatalogue& catalogue() {
  static const MeasureCatalogue measures = {
      {"tracker.delay", "ms"},
      {"tracker.error.max", "mHz"},
      {"tracker.error.rms", "mHz"},
      {"tracker.bias", "mHz"},
      {"tracker.rocof_error.rms", "Hz/s"},
      {"event.count", ""},
      {"event.false", ""},
      {"event.delay", "ms"},
      {"condition.hits", ""},
      {"lse.loss", "MW"},
      {"lse.error", "%"},
      {"ekf.loss", "MW"},
      {"ekf.error", "%"},
      {"ekf.t_x_error", "ms"},
      {"decision.delay", "ms"},
      {"decision.cause", "", true, {"none", "loss", "frequency", "command"}},
      {"relay.delay", "ms"},
      {"relay.delay_by_word", "ms"},
      {"relay.operate_time", "ms"},
      {"relay.word_difference", "ms"},
      {"relay.end", "", true, {"closed", "open"}},
      {"relay.edges", ""},
      {"relay.chatter", ""},
      {"command.delay", "ms"},
      {"validity.dead_bus_claims", ""},
      {"validity.valid_share", "%"},
      {"trip.time", "s"},
      {"clock.drift", "ppm"},
      {"clock.uncertainty", "ms"},
  };
  return measures;
}

}  // namespace gsbench::profile::test
