// Brings what outlets say and what the relay sense sees onto one time base, as records.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <capture/clock.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::capture {

// What outlets say is kept by their own sample counts and comes onto the run's time base when it is
// moved into the record; edges and commands are given in ticks of the run. Outlets are known by
// their ids; of one that nothing came from all is empty.
class Capture {
 public:
  explicit Capture(std::int64_t sample_rate_hz)
      : sample_rate_hz_(static_cast<double>(sample_rate_hz)) {}

  void add(const std::vector<link::Received>& messages);
  void add_edge(const std::string& id, std::int64_t tick, bool closed);
  void add_command(const std::string& id, std::int64_t tick, bool close);

  // What the outlet answered to its settings; none: no answer came.
  std::optional<gs::outlet::SettingsError> settings_answer(const std::string& id) const {
    return track(id).settings_answer;
  }
  // Bits of gs::wire::SelfTestPart; 0 also where no result came.
  std::uint32_t self_test_failed(const std::string& id) const { return track(id).self_test_failed; }
  // Stamp of the newest measurement; 0 before the first.
  std::uint64_t last_report_sample(const std::string& id) const;
  VoltageTrace voltage_trace(const std::string& id) const;  // its window is for the caller to set

  // Of the outlet record.id: the record's traces, estimates and marks (ascending in time) of the
  // run itself, from tick 0 to its last; what was before and after is left out. Nothing is kept.
  void move_into(record::OutletRecord& record, const OutletClock& clock, std::int64_t last_tick);

 private:
  struct Track {
    struct Measurement {
      std::int64_t sample;
      gs::wire::MeasurementMessage said;
    };
    struct Estimate {
      std::int64_t sample;
      std::int64_t event_sample;  // of the event it is of
      gs::wire::EstimateMessage said;
    };
    std::vector<Measurement> measurements;
    std::vector<Estimate> estimates;
    std::vector<record::Mark> marks;  // ticks in them are still samples of the outlet
    std::vector<record::Mark> bench_marks;
    std::string settings_digest;
    std::optional<gs::outlet::SettingsError> settings_answer;
    std::uint32_t self_test_failed = 0;
    std::int64_t newest_event_sample = 0;
  };

  static void add(Track& track, const gs::wire::Uplink& message);
  const Track& track(const std::string& id) const;

  std::map<std::string, Track> tracks_;
  double sample_rate_hz_;
};

// One entry every 16 ms and two at each corner, just before it and at it, then thinned: straight
// lines between those that are left are right within 0.05 mHz and 5 mHz/s at those that are not.
record::ReferenceTrace reference_trace(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz);

}  // namespace gsbench::capture
