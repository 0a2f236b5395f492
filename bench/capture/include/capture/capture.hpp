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
  // Of the first `outlets` of a station; what others say is not for the record.
  Capture(std::size_t outlets, std::int64_t sample_rate_hz);

  void add(const std::vector<link::Received>& messages);
  void add(const std::vector<relay::Edge>& edges);
  void add_command(std::size_t outlet, std::int64_t tick, bool close);

  const SettingsAnswer& settings_answer(std::size_t outlet) const;
  // Of the newest measurement; 0 before the first.
  std::int64_t last_report_tick(std::size_t outlet) const;

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
