// Brings what outlets say and what the relay sense sees onto one time base, as records.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <capture/clock.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>

namespace gsbench::capture {

// What an outlet answered to its settings.
struct SettingsAnswer {
  bool came = false;
  bool accepted = false;
  std::string reason;  // where it refused
};

// What outlets say is kept by their own sample counts and comes onto the run's time base when it is
// moved into the record; edges and commands are given in ticks of the run.
class Capture {
 public:
  // Of the first `outlets` of a station; what others say is not for the record.
  Capture(std::size_t outlets, std::int64_t sample_rate_hz);

  void add(const std::vector<link::Received>& messages);
  void add_edge(std::size_t outlet, std::int64_t tick, bool closed);
  void add_command(std::size_t outlet, std::int64_t tick, bool close);

  const SettingsAnswer& settings_answer(std::size_t outlet) const;
  // Bits of gs::wire::SelfTestPart; 0 also where no result came.
  std::uint32_t self_test_failed(std::size_t outlet) const;
  // Stamp of the newest measurement; 0 before the first.
  std::uint64_t last_report_sample(std::size_t outlet) const;
  VoltageTrace voltage_trace(std::size_t outlet) const;  // its window is for the caller to set

  // The records' traces, estimates and marks (ascending in time) of the run itself, from tick 0 to
  // its last; what was before and after is left out. The capture is empty afterwards.
  void move_into(std::size_t outlet, const OutletClock& clock, std::int64_t last_tick,
                 record::OutletRecord& record);

 private:
  struct Track {
    record::OutletRecord record;  // ticks in it are still samples of the outlet
    std::vector<record::Mark> bench_marks;
    std::vector<float> loss_instant_s;  // of each estimate, against its event
    std::vector<std::int64_t> event_sample;
    SettingsAnswer settings_answer;
    std::uint32_t self_test_failed = 0;
    std::int64_t newest_event_sample = 0;
  };

  void add(Track& track, const link::Received& received) const;

  std::vector<Track> tracks_;
  double sample_rate_hz_;
};

}  // namespace gsbench::capture
