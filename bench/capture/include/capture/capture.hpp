// Brings what outlets say and what the relay sense sees onto one time base, as records.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <record/run_record.hpp>
#include <relay/relay_sense.hpp>

namespace gsbench::capture {

// What an outlet answered to its settings.
struct SettingsAnswer {
  bool came = false;
  bool accepted = false;
  std::string reason;  // where it refused
};

class Capture {
 public:
  Capture(std::size_t outlets, std::int64_t sample_rate_hz);

  void add(const std::vector<link::Received>& messages);
  void add(const std::vector<relay::Edge>& edges);
  void add_command(std::size_t outlet, std::int64_t tick, bool close);

  const SettingsAnswer& settings_answer(std::size_t outlet) const;
  // Reports so far: an outlet that has fallen silent has fewer than its neighbours.
  std::size_t reports(std::size_t outlet) const;

  // The records' traces, estimates and marks (ascending in time); the capture is empty afterwards.
  void move_into(std::size_t outlet, record::OutletRecord& record);

 private:
  struct Track {
    record::OutletRecord record;
    SettingsAnswer settings_answer;
    std::int64_t event_tick = 0;
  };

  void add(Track& track, const link::Received& received) const;

  std::vector<Track> tracks_;
  double sample_rate_hz_;
};

}  // namespace gsbench::capture
