// Collects the outlets' reports, the edges of the relay sense and what is sent, for the record.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include <link/link.hpp>
#include <record/run_record.hpp>
#include <waveform/reference_signal.hpp>

namespace gsbench::capture {

// Reports keep the outlets' own sample counts. Edges, commands and settings are given in ticks of
// the run. Outlets are identified by their ids; an unknown id has empty contents.
class Capture {
 public:
  void add(const std::vector<link::Received>& messages);
  void add_edge(const std::string& id, std::int64_t tick, bool closed);
  void add_command(const std::string& id, std::int64_t tick, bool close);
  // Settings that are sent again during the run. `changes`: what has changed, for people.
  void add_settings(const std::string& id, std::int64_t tick, std::uint32_t version,
                    const std::string& changes);
  void add_sent(const std::string& id, record::Sent sent);

  // The outlet's answers to all settings that were sent to it, in this order.
  const std::vector<gs::outlet::SettingsError>& settings_answers(const std::string& id) const {
    return track(id).settings_answers;
  }
  // Of the first settings that it acknowledged, hexadecimal; empty before its answer.
  const std::string& settings_digest(const std::string& id) const {
    return track(id).settings_digest;
  }
  // Bits of gs::wire::SelfTestPart; 0 if all passed, or no result came.
  std::uint32_t self_test_failed(const std::string& id) const { return track(id).self_test_failed; }
  // Sample count of the latest measurement; 0 before the first.
  std::uint64_t last_report_sample(const std::string& id) const {
    return static_cast<std::uint64_t>(track(id).newest_sample);
  }

  // What has come for the outlet since the last call, as record::Store::append() takes it.
  record::Reports take(const std::string& id);

 private:
  struct Track {
    record::Reports reports;
    std::string settings_digest;
    std::vector<gs::outlet::SettingsError> settings_answers;
    std::uint32_t self_test_failed = 0;
    std::int64_t newest_sample = 0;
    std::int64_t newest_event_sample = 0;
  };

  static void add(Track& track, const gs::wire::Uplink& message);
  const Track& track(const std::string& id) const;

  std::map<std::string, Track> tracks_;
};

// Samples the reference every 16 ms and on both sides of each corner. Entries are omitted if linear
// interpolation reproduces them within 0.05 mHz and 5 mHz/s.
record::ReferenceTrace reference_trace(const waveform::ReferenceSignal& reference,
                                       std::int64_t duration_ticks, std::int64_t sample_rate_hz);

}  // namespace gsbench::capture
