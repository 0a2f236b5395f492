// Collects the outlets' reports, the edges of the relay sense and the commands, and stores them as
// records on one time base.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <capture/clock.hpp>
#include <link/link.hpp>
#include <record/run_record.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::capture {

// Reports are stored with the outlets' own sample counts and converted to the run's time base in
// move_into(). Edges and commands are given in ticks of the run. Outlets are identified by their
// ids; an unknown id has empty contents.
class Capture {
 public:
  explicit Capture(std::int64_t sample_rate_hz)
      : sample_rate_hz_(static_cast<double>(sample_rate_hz)) {}

  void add(const std::vector<link::Received>& messages);
  void add_edge(const std::string& id, std::int64_t tick, bool closed);
  void add_command(const std::string& id, std::int64_t tick, bool close);
  // Settings that are sent again during the run. `changes`: what has changed, for people.
  void add_settings(const std::string& id, std::int64_t tick, std::uint32_t version,
                    const std::string& changes);

  // The outlet's answers to all settings that were sent to it, in this order.
  const std::vector<gs::outlet::SettingsError>& settings_answers(const std::string& id) const {
    return track(id).settings_answers;
  }
  // Bits of gs::wire::SelfTestPart; 0 if all passed, or no result came.
  std::uint32_t self_test_failed(const std::string& id) const { return track(id).self_test_failed; }
  // Sample count of the latest measurement; 0 before the first.
  std::uint64_t last_report_sample(const std::string& id) const;
  // Does not fill in window_samples; the caller sets it.
  VoltageTrace voltage_trace(const std::string& id) const;

  // Moves the traces, estimates and marks (ascending in time) of the outlet record.id into the
  // record. Only tick 0 … last_tick is kept. The outlet's contents are empty afterwards.
  void move_into(record::OutletRecord& record, const OutletClock& clock, std::int64_t last_tick);

 private:
  struct Track {
    struct Measurement {
      std::int64_t sample;
      gs::wire::MeasurementMessage message;
    };
    struct Estimate {
      std::int64_t sample;
      std::int64_t event_sample;  // of the event that it belongs to
      gs::wire::EstimateMessage message;
    };
    std::vector<Measurement> measurements;
    std::vector<Estimate> estimates;
    std::vector<record::Mark> marks;  // their ticks are samples of the outlet
    std::vector<record::Mark> bench_marks;
    std::string settings_digest;  // of the first settings
    std::vector<gs::outlet::SettingsError> settings_answers;
    std::uint32_t self_test_failed = 0;
    std::int64_t newest_event_sample = 0;
  };

  static void add(Track& track, const gs::wire::Uplink& message);
  const Track& track(const std::string& id) const;

  std::map<std::string, Track> tracks_;
  double sample_rate_hz_;
};

// Samples the reference every 16 ms and on both sides of each corner. Entries are omitted if linear
// interpolation reproduces them within 0.05 mHz and 5 mHz/s.
record::ReferenceTrace reference_trace(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz);

}  // namespace gsbench::capture
