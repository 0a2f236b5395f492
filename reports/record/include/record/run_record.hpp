// The stored results of a run, from which all reports are made. Plain data without types of the
// bench or the firmware, so that old records stay readable when those change.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace gsbench::record {

// Version of the records that are written, and of result.json.
constexpr int kFormatVersion = 7;

// Ordered from good to bad: combine verdicts with std::max.
enum class Verdict : std::uint8_t { kPass = 0, kInconclusive = 1, kFail = 2, kError = 3 };

const char* to_string(Verdict verdict);  // "PASS", "INCONCLUSIVE", "FAIL", "ERROR"

// One measurement of one outlet. NaN in value: not measured. NaN in low or high: no limit.
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
  bool judged = false;       // false: for information, without a limit
  Verdict verdict = Verdict::kPass;
  std::string reason;  // why it is not PASS, or where the value comes from
};

// Something that happened to an outlet at one instant.
struct Mark {
  std::int64_t tick = 0;
  std::string kind;  // "event", "lse", "decision", "relay.reported", "relay.sense", "command", …
  double value = 0.0;      // depends on `kind`: MW, 1 closed / 0 open, …
  std::string text;        // reason or note
  bool by_outlet = false;  // stamped by the outlet; false: by the bench
};

// A message that was sent to an outlet.
struct Sent {
  std::int64_t tick = 0;  // of the source, on the run's time base; below 0 before the run
  std::string kind;       // "settings", "command", "ask self test"
  // As on the wire (firmware/wire), but with sequence number 0 and session 1: the link has its own.
  std::vector<std::uint8_t> message;
};

// One entry per report of the outlet (every 16 ms); all columns have equal length.
struct MeasurementTrace {
  std::vector<std::int64_t> tick;
  std::vector<float> frequency_hz;  // NaN if the report has no frequency
  std::vector<float> rocof_hz_s;
  std::vector<float> voltage_pu;
  std::vector<std::uint8_t> validity;  // 0 invalid, 1 valid, 2 held
};

// One entry per ΔP estimate; all columns have equal length.
struct EstimateTrace {
  std::vector<std::int64_t> tick;
  std::vector<float> loss_mw;
  std::vector<float> loss_sigma_mw;
  std::vector<std::int64_t> event_tick;  // of the event that the estimate belongs to
  std::vector<float> loss_after_event_s;
  std::vector<std::uint8_t> trusted;  // 1 trusted, 0 not
};

// Appends entry i of `from`.
void append(const MeasurementTrace& from, std::size_t i, MeasurementTrace& to);
void append(const EstimateTrace& from, std::size_t i, EstimateTrace& to);

// Time of the loss by estimate i, on the run's time base, s.
double loss_instant_s(const EstimateTrace& estimates, std::size_t i, double sample_rate_hz);

// The outlet's sample clock, compared with the source's ticks. The first three members are zero if
// the outlet has no clock of its own but counts the source's ticks, as simulated outlets do.
struct Clock {
  double drift_ppm = 0.0;              // positive if its crystal runs fast
  double drift_uncertainty_ppm = 0.0;  // expanded, k = 2
  double uncertainty_ms = 0.0;         // of its time stamps on the run's time base, expanded
  // tick = (sample − sample_at_zero) / samples_per_tick
  double sample_at_zero = 0.0;
  double samples_per_tick = 1.0;  // 0: the clock is not aligned

  bool is_aligned() const { return samples_per_tick > 0.0; }
  bool counts_ticks() const { return sample_at_zero == 0.0 && samples_per_tick == 1.0; }
  std::int64_t tick_of(std::int64_t sample) const;
};

// What an outlet reported and was sent, and what the bench saw of it, in the order of time: all of
// a run, or what came within half a second of it. The columns and the marks that the outlet stamped
// have its own sample counts until place_on_run_time.
struct Reports {
  std::vector<Mark> marks;
  std::vector<Sent> sent;
  MeasurementTrace trace;
  EstimateTrace estimates;

  bool empty() const;
  void append(const Reports& later);
};

// Takes the reports of one outlet piece by piece, in the order in which they came.
using TakeReports = std::function<void(const Reports& piece)>;

struct OutletRecord {
  std::string id;
  bool took_part = false;  // false: it was not part of the run, and there is nothing to judge
  std::string group;
  std::string link;  // "simulated", "/dev/ttyUSB0", …; empty: none
  // From its hello.
  std::string board;
  std::uint64_t instance = 0;          // unique number of the unit
  std::string firmware;                // version
  std::string build;                   // digest of its firmware's sources, hexadecimal
  std::uint64_t protocol_version = 0;  // 0: it has sent no hello

  std::string settings_digest;  // of the settings it acknowledged, hexadecimal
  std::string fault;            // first communication or outlet fault; empty: none
  bool relay_sensed = true;     // the bench senses its relay contact
  Clock clock;
  std::map<std::string, double> settings;  // the first that it was sent; the unit is in the name
  Verdict verdict = Verdict::kPass;
  std::vector<MeasurementResult> measurements;
  Reports reports;
};

// Converts the sample counts of an outlet with this clock to ticks of the run, drops what is
// outside of tick 0 … last_tick, and sorts the marks by time. Without an aligned clock, only what
// the bench stamped is left. Of an outlet that counts the source's ticks, only the marks are
// sorted.
void place_on_run_time(Reports& reports, const Clock& clock, std::int64_t last_tick);

// The reference frequency, thinned: linear interpolation between entries is within 0.05 mHz.
struct ReferenceTrace {
  std::vector<std::int64_t> tick;
  std::vector<double> frequency_hz;
  std::vector<double> rocof_hz_s;
};

// A computed figure and the published one.
struct Comparison {
  std::string name;
  std::string unit;
  double ours = 0.0;
  double published = 0.0;
  std::string note;  // why they differ; may be empty
};

// The CSV recording whose frequency was played. All empty if there was none.
struct Recording {
  std::string file;    // path as given
  std::string sha256;  // of the whole file
  std::string time;    // column name, as are the next two members
  std::string frequency;
  std::string voltage;            // empty: nominal voltage
  double nominal_voltage = 0.0;   // in that column's unit; 0: the column's median
  bool replaces_profile = false;  // given by --trace, in place of the profile's own signal
  std::string options = {};       // how it was read: the keys of [signal.trace] but `file`
  std::string text = {};          // the part of the file that was played, in bytes of the file
  std::uint64_t rows = 0;         // of that part, with gaps; 0 in older records
  std::uint64_t gaps = 0;         // rows without a value
};

// Uncertainty of the bench, expanded (k = 2), without that of the outlets' clocks.
struct BenchUncertainty {
  double relay_sense_ms = 0.0;  // of the time of an edge on the time base of the run
  double command_ms = 0.0;      // of the time from the sending of a command to an edge
  // Of the played voltage, as the source states them.
  double frequency_mhz = 0.0;
  double voltage_pct = 0.0;  // of the nominal peak amplitude
  double time_ms = 0.0;
};

// How the times of a device were put on the time base of the run.
struct AlignedClock {
  std::string what;  // "source", "relay sense", the ids of outlets
  std::string aligned_by;
  double uncertainty_ms = 0.0;  // expanded, k = 2
};

// What played the signal.
struct SourceUsed {
  std::string name;      // maker and model
  std::string how;       // how the signal was played; lines
  std::string accuracy;  // where its deviations come from; empty: it plays exactly
};

struct RunRecord {
  std::string run_id;       // unique
  std::string started_utc;  // ISO 8601, wall clock
  std::string finished_utc;
  std::string software;        // versions of the libraries and of the system; one line each
  std::string content_sha256;  // as content_digest(); empty before the end
  std::string gsbench_version;
  std::string profile;  // name
  std::string profile_title;
  std::string profile_source;
  std::string profile_sha256;
  std::string profile_text;
  std::string grid;
  std::string grid_sha256;  // of the grid file; empty if the grid is part of the profile
  std::string grid_text;    // its content
  Recording recording;
  std::string station;          // "simulated"
  std::string station_text;     // content of the station file
  std::string noise;            // "1 % white, independent at each outlet"
  std::string firmware_sha256;  // of the firmware sources in this build
  std::uint64_t seed = 0;
  std::int64_t sample_rate_hz = 0;
  std::int64_t duration_ticks = 0;
  double nominal_hz = 50.0;
  SourceUsed source;
  BenchUncertainty bench_uncertainty;
  bool interrupted = false;  // by a signal, before its end
  std::string fault;         // fault of the bench that ended the run; empty: none
  Verdict verdict = Verdict::kPass;
  std::string verdict_reason;  // one sentence; empty for PASS
  std::vector<AlignedClock> clocks;
  std::vector<Comparison> comparisons;
  ReferenceTrace reference;
  std::vector<Mark> stimulus;  // losses, phase steps, dips, …, as played
  std::vector<OutletRecord> outlets;
};

// False if the run was interrupted or ended by a fault of the bench: no outlet is judged then.
bool is_judged(const RunRecord& run);

// nullptr if the outlet has no such measurement.
const MeasurementResult* find_measurement(const OutletRecord& outlet, const std::string& name);

// Linear interpolation, Hz; NaN before the first and after the last entry.
double frequency_hz(const ReferenceTrace& reference, std::int64_t tick);

}  // namespace gsbench::record
