// The one list of what each part of a record holds. Tables, rows and digests are all made from it,
// so that a field cannot be stored and not read, or read and not sealed.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <record/run_record.hpp>

namespace gsbench::record {

// One entry of OutletRecord::settings.
struct Setting {
  std::string name;
  double value = 0.0;
};

// One packed column of a trace (see columns.hpp).
struct Series {
  std::string name;
  std::int64_t entries = 0;
  std::vector<std::uint8_t> data;
};

// Closes what one owner (the run or an outlet) has stored: how a damaged file is told.
struct Seal {
  bool complete = false;  // the run: finish() was called
  std::string sha256;
};

std::string seal_of_run(const RunRecord& head, bool complete);
std::string seal_of_outlet(const OutletRecord& outlet);

// Fields<T>::visit(object, visitor) calls visitor(name, member) for each field in a fixed order.
template <class T>
struct Fields;

template <>
struct Fields<RunRecord> {
  static constexpr const char* kTable = "run";
  template <class Self, class Visitor>
  static void visit(Self& run, Visitor&& visitor) {
    visitor("run_id", run.run_id);
    visitor("started_utc", run.started_utc);
    visitor("finished_utc", run.finished_utc);
    visit_content(run, std::forward<Visitor>(visitor));
  }
  // What is equal for equal profile, seed and build.
  template <class Self, class Visitor>
  static void visit_content(Self& run, Visitor&& visitor) {
    visitor("gsbench_version", run.gsbench_version);
    visitor("profile", run.profile);
    visitor("profile_title", run.profile_title);
    visitor("profile_source", run.profile_source);
    visitor("profile_sha256", run.profile_sha256);
    visitor("profile_text", run.profile_text);
    visitor("grid", run.grid);
    visitor("grid_sha256", run.grid_sha256);
    visitor("recording_file", run.recording.file);
    visitor("recording_sha256", run.recording.sha256);
    visitor("recording_time", run.recording.time);
    visitor("recording_frequency", run.recording.frequency);
    visitor("recording_voltage", run.recording.voltage);
    visitor("recording_nominal_voltage", run.recording.nominal_voltage);
    visitor("recording_replaces_profile", run.recording.replaces_profile);
    visitor("station", run.station);
    visitor("noise", run.noise);
    visitor("firmware_sha256", run.firmware_sha256);
    visitor("seed", run.seed);
    visitor("sample_rate_hz", run.sample_rate_hz);
    visitor("duration_ticks", run.duration_ticks);
    visitor("nominal_hz", run.nominal_hz);
    visitor("uncertainty_relay_sense_ms", run.bench_uncertainty.relay_sense_ms);
    visitor("uncertainty_frequency_mhz", run.bench_uncertainty.frequency_mhz);
    visitor("interrupted", run.interrupted);
    visitor("fault", run.fault);
    visitor("verdict", run.verdict);
    visitor("verdict_reason", run.verdict_reason);
  }
};

template <>
struct Fields<OutletRecord> {
  static constexpr const char* kTable = "outlet";
  template <class Self, class Visitor>
  static void visit(Self& outlet, Visitor&& visitor) {
    visitor("id", outlet.id);
    visitor("took_part", outlet.took_part);
    visitor("group", outlet.group);
    visitor("link", outlet.link);
    visitor("firmware", outlet.firmware);
    visitor("settings_digest", outlet.settings_digest);
    visitor("fault", outlet.fault);
    visitor("relay_sensed", outlet.relay_sensed);
    visitor("clock_drift_ppm", outlet.clock.drift_ppm);
    visitor("clock_drift_uncertainty_ppm", outlet.clock.drift_uncertainty_ppm);
    visitor("clock_uncertainty_ms", outlet.clock.uncertainty_ms);
    visitor("verdict", outlet.verdict);
  }
};

template <>
struct Fields<Setting> {
  static constexpr const char* kTable = "setting";
  template <class Self, class Visitor>
  static void visit(Self& setting, Visitor&& visitor) {
    visitor("name", setting.name);
    visitor("value", setting.value);
  }
};

template <>
struct Fields<MeasurementResult> {
  static constexpr const char* kTable = "measurement";
  template <class Self, class Visitor>
  static void visit(Self& result, Visitor&& visitor) {
    visitor("name", result.name);
    visitor("definition", result.definition);
    visitor("value", result.value);
    visitor("word", result.word);
    visitor("expected_word", result.expected_word);
    visitor("unit", result.unit);
    visitor("low", result.low);
    visitor("high", result.high);
    visitor("uncertainty", result.uncertainty);
    visitor("judged", result.judged);
    visitor("verdict", result.verdict);
    visitor("reason", result.reason);
  }
};

template <>
struct Fields<Mark> {
  static constexpr const char* kTable = "mark";
  template <class Self, class Visitor>
  static void visit(Self& mark, Visitor&& visitor) {
    visitor("tick", mark.tick);
    visitor("kind", mark.kind);
    visitor("value", mark.value);
    visitor("text", mark.text);
  }
};

template <>
struct Fields<Comparison> {
  static constexpr const char* kTable = "comparison";
  template <class Self, class Visitor>
  static void visit(Self& comparison, Visitor&& visitor) {
    visitor("name", comparison.name);
    visitor("unit", comparison.unit);
    visitor("ours", comparison.ours);
    visitor("published", comparison.published);
    visitor("note", comparison.note);
  }
};

template <>
struct Fields<Series> {
  static constexpr const char* kTable = "series";
  template <class Self, class Visitor>
  static void visit(Self& series, Visitor&& visitor) {
    visitor("name", series.name);
    visitor("entries", series.entries);
    visitor("data", series.data);
  }
};

template <>
struct Fields<Seal> {
  static constexpr const char* kTable = "seal";
  template <class Self, class Visitor>
  static void visit(Self& seal, Visitor&& visitor) {
    visitor("complete", seal.complete);
    visitor("sha256", seal.sha256);
  }
};

// Traces: every field is a column, kept as a Series of that name.

template <>
struct Fields<MeasurementTrace> {
  template <class Self, class Visitor>
  static void visit(Self& trace, Visitor&& visitor) {
    visitor("trace.tick", trace.tick);
    visitor("trace.frequency_hz", trace.frequency_hz);
    visitor("trace.rocof_hz_s", trace.rocof_hz_s);
    visitor("trace.voltage_pu", trace.voltage_pu);
    visitor("trace.validity", trace.validity);
  }
};

template <>
struct Fields<EstimateTrace> {
  template <class Self, class Visitor>
  static void visit(Self& trace, Visitor&& visitor) {
    visitor("estimates.tick", trace.tick);
    visitor("estimates.loss_mw", trace.loss_mw);
    visitor("estimates.loss_sigma_mw", trace.loss_sigma_mw);
    visitor("estimates.t_x_s", trace.t_x_s);
    visitor("estimates.trusted", trace.trusted);
  }
};

template <>
struct Fields<TruthTrace> {
  template <class Self, class Visitor>
  static void visit(Self& trace, Visitor&& visitor) {
    visitor("truth.tick", trace.tick);
    visitor("truth.frequency_hz", trace.frequency_hz);
    visitor("truth.rocof_hz_s", trace.rocof_hz_s);
  }
};

}  // namespace gsbench::record
