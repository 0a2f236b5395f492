// What is kept of a run, and all that reports are made from. Plain data in the order it is written;
// no type of the bench or of an outlet occurs here, so that a record outlives both.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gsbench::record {

// A verdict only worsens: combine with std::max.
enum class Verdict : std::uint8_t { kPass = 0, kInconclusive = 1, kFail = 2, kError = 3 };

const char* to_string(Verdict verdict);  // "PASS", "INCONCLUSIVE", "FAIL", "ERROR"

// One judged measurement of one outlet. NaN in value: not measured. NaN in low or high: no limit.
struct MeasurementResult {
  std::string name;        // of the catalogue: "event.delay"
  std::string definition;  // one sentence
  double value = 0.0;
  std::string text;  // value of a measure with text values ("open"); empty for a number
  std::string expected_text;
  std::string unit;
  double low = 0.0;
  double high = 0.0;
  double uncertainty = 0.0;  // expanded, k = 2, in `unit`
  bool judged = false;       // false: for information, no limit declared
  Verdict verdict = Verdict::kPass;
  std::string reason;  // why not PASS, or where the value comes from
};

// Something that happened to an outlet at one instant.
struct Mark {
  std::int64_t tick = 0;
  std::string kind;  // "event", "lse", "decision", "relay.reported", "relay.sense", "command", …
  double value = 0.0;  // what `kind` says: MW, 1 closed / 0 open, …
  std::string text;    // reason or note, for people
};

// Regular series, one entry a report of the outlet (16 ms); all columns have equal length.
struct MeasurementTrace {
  std::vector<std::int64_t> tick;
  std::vector<float> frequency_hz;  // NaN where the outlet claims none
  std::vector<float> rocof_hz_s;
  std::vector<float> voltage_pu;
  std::vector<std::uint8_t> validity;  // 0 invalid, 1 valid, 2 held
};

// ΔP estimates, one entry an estimate; equal lengths.
struct EstimateTrace {
  std::vector<std::int64_t> tick;
  std::vector<float> loss_mw;
  std::vector<float> loss_sigma_mw;
  std::vector<float> t_x_s;           // time of the loss on the run's time base, s
  std::vector<std::uint8_t> trusted;  // 1 trusted, 0 not
};

// An outlet's sample count against the source's ticks. All zero where it counts the very ticks.
struct Clock {
  double drift_ppm = 0.0;              // by how much its crystal is fast
  double drift_uncertainty_ppm = 0.0;  // expanded, k = 2
  double uncertainty_ms = 0.0;         // of its stamps on the run's time base, expanded
};

struct OutletRecord {
  std::string id;
  bool took_part = false;  // it was taken into the run; else there is nothing to judge
  std::string group;
  std::string link;      // where it is reached: "simulated", "/dev/ttyUSB0"; empty: it has none
  std::string firmware;  // version and digest it said of itself
  std::string settings_digest;  // that it acknowledged, hexadecimal
  std::string fault;            // what first went wrong between the bench and it; empty: nothing
  bool relay_sensed = true;     // the bench's relay sense looks at its contact
  Clock clock;
  std::map<std::string, double> settings;  // what it was sent, unit in the name
  Verdict verdict = Verdict::kPass;
  std::vector<MeasurementResult> measurements;
  std::vector<Mark> marks;
  MeasurementTrace trace;
  EstimateTrace estimates;
};

// The true frequency, thinned so that straight lines between entries are right within 0.05 mHz.
struct ReferenceTrace {
  std::vector<std::int64_t> tick;
  std::vector<double> frequency_hz;
  std::vector<double> rocof_hz_s;
};

// A figure of ours beside a published one.
struct Comparison {
  std::string name;
  std::string unit;
  double ours = 0.0;
  double published = 0.0;
  std::string note;  // why they differ; may be empty
};

// A CSV recording whose frequency was played. All empty where none was.
struct Recording {
  std::string file;  // as it was named
  std::string sha256;
  std::string time;  // columns
  std::string frequency;
  std::string voltage;            // empty: nominal voltage
  double nominal_voltage = 0.0;   // in that column's unit; 0: the column's median
  bool replaces_profile = false;  // it came in place of what the profile itself would have played
};

// What the bench itself can get wrong, expanded (k = 2); an outlet's clock is in its own record.
struct BenchUncertainty {
  double relay_sense_ms = 0.0;  // an edge's time
  double frequency_mhz = 0.0;   // of what the source plays
};

struct RunRecord {
  std::string run_id;       // unique; differs from run to run
  std::string started_utc;  // ISO 8601; wall clock, differs from run to run
  std::string finished_utc;
  std::string gsbench_version;
  std::string profile;  // name
  std::string profile_title;
  std::string profile_source;
  std::string profile_sha256;
  std::string profile_text;
  std::string grid;
  std::string grid_sha256;  // of the grid file's text; empty where the profile holds the grid
  Recording recording;
  std::string station;          // "simulated"
  std::string noise;            // "1 % white, independent at each outlet"
  std::string firmware_sha256;  // of the firmware sources in this build
  std::uint64_t seed = 0;
  std::int64_t sample_rate_hz = 0;
  std::int64_t duration_ticks = 0;
  double nominal_hz = 50.0;
  BenchUncertainty bench_uncertainty;
  bool interrupted = false;  // stopped from outside before its end
  std::string fault;         // of the bench, which ended the run; empty: none
  Verdict verdict = Verdict::kPass;
  std::string verdict_reason;  // one sentence where it is not PASS
  std::vector<Comparison> comparisons;
  ReferenceTrace reference;
  std::vector<Mark> stimulus;  // losses, phase jumps, dips … as played
  std::vector<OutletRecord> outlets;
};

// nullptr where the outlet has no such measurement.
const MeasurementResult* find_measurement(const OutletRecord& outlet, const std::string& name);

// On the straight lines between entries; NaN before the first and after the last.
double frequency_hz(const ReferenceTrace& reference, std::int64_t tick);

}  // namespace gsbench::record
