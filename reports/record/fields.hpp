// The list of the fields of each part of a record. Tables, rows and digests are generated from it,
// so that no field can be stored but not read, or read but not covered by a digest.
#pragma once

#include <cstdint>
#include <string>
#include <type_traits>
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

// A digest of what is stored. One that does not match shows that the file is damaged. An outlet has
// one for its results and one for each append of its reports, which covers the one before. In
// version 6 it has one for all.
struct Seal {
  bool complete = false;  // for the run: finish() was called
  std::string sha256;
};

// visit_fields<T>(object, visitor) calls visitor(name, member) for each field in a fixed order.
template <class T>
inline constexpr auto visit_fields = nullptr;

// Name of the table that holds parts of this type, one a row; nullptr if there is none.
template <class T>
inline constexpr const char* table_name = nullptr;

// Fields that are equal in all runs with equal profile, seed and build.
inline constexpr auto visit_content = [](auto& run, auto&& visitor) {
  visitor("gsbench_version", run.gsbench_version);
  visitor("profile", run.profile);
  visitor("profile_title", run.profile_title);
  visitor("profile_source", run.profile_source);
  visitor("profile_sha256", run.profile_sha256);
  visitor("profile_text", run.profile_text);
  visitor("grid", run.grid);
  visitor("grid_sha256", run.grid_sha256);
  visitor("grid_text", run.grid_text);
  visitor("recording_file", run.recording.file);
  visitor("recording_sha256", run.recording.sha256);
  visitor("recording_options", run.recording.options);
  visitor("recording_text", run.recording.text);
  visitor("recording_rows", run.recording.rows);
  visitor("recording_gaps", run.recording.gaps);
  visitor("recording_time", run.recording.time);
  visitor("recording_frequency", run.recording.frequency);
  visitor("recording_voltage", run.recording.voltage);
  visitor("recording_nominal_voltage", run.recording.nominal_voltage);
  visitor("recording_replaces_profile", run.recording.replaces_profile);
  visitor("station", run.station);
  visitor("station_text", run.station_text);
  visitor("noise", run.noise);
  visitor("firmware_sha256", run.firmware_sha256);
  visitor("seed", run.seed);
  visitor("sample_rate_hz", run.sample_rate_hz);
  visitor("duration_ticks", run.duration_ticks);
  visitor("nominal_hz", run.nominal_hz);
  visitor("uncertainty_relay_sense_ms", run.bench_uncertainty.relay_sense_ms);
  visitor("uncertainty_command_ms", run.bench_uncertainty.command_ms);
  visitor("uncertainty_frequency_mhz", run.bench_uncertainty.frequency_mhz);
  visitor("uncertainty_voltage_pct", run.bench_uncertainty.voltage_pct);
  visitor("uncertainty_time_ms", run.bench_uncertainty.time_ms);
  visitor("source_name", run.source.name);
  visitor("source_how", run.source.how);
  visitor("source_accuracy", run.source.accuracy);
  visitor("interrupted", run.interrupted);
  visitor("fault", run.fault);
  visitor("verdict", run.verdict);
  visitor("verdict_reason", run.verdict_reason);
};

template <>
inline constexpr const char* table_name<RunRecord> = "run";
template <>
inline constexpr auto visit_fields<RunRecord> = [](auto& run, auto&& visitor) {
  visitor("run_id", run.run_id);
  visitor("started_utc", run.started_utc);
  visitor("finished_utc", run.finished_utc);
  visitor("software", run.software);
  visitor("content_sha256", run.content_sha256);
  visit_content(run, visitor);
};

template <>
inline constexpr const char* table_name<OutletRecord> = "outlet";
template <>
inline constexpr auto visit_fields<OutletRecord> = [](auto& outlet, auto&& visitor) {
  visitor("id", outlet.id);
  visitor("took_part", outlet.took_part);
  visitor("group", outlet.group);
  visitor("link", outlet.link);
  visitor("board", outlet.board);
  visitor("instance", outlet.instance);
  visitor("firmware", outlet.firmware);
  visitor("build", outlet.build);
  visitor("protocol_version", outlet.protocol_version);
  visitor("settings_digest", outlet.settings_digest);
  visitor("fault", outlet.fault);
  visitor("relay_sensed", outlet.relay_sensed);
  visitor("clock_drift_ppm", outlet.clock.drift_ppm);
  visitor("clock_drift_uncertainty_ppm", outlet.clock.drift_uncertainty_ppm);
  visitor("clock_uncertainty_ms", outlet.clock.uncertainty_ms);
  visitor("clock_sample_at_zero", outlet.clock.sample_at_zero);
  visitor("clock_samples_per_tick", outlet.clock.samples_per_tick);
  visitor("verdict", outlet.verdict);
};

template <>
inline constexpr const char* table_name<Setting> = "setting";
template <>
inline constexpr auto visit_fields<Setting> = [](auto& setting, auto&& visitor) {
  visitor("name", setting.name);
  visitor("value", setting.value);
};

template <>
inline constexpr const char* table_name<MeasurementResult> = "measurement";
template <>
inline constexpr auto visit_fields<MeasurementResult> = [](auto& result, auto&& visitor) {
  visitor("name", result.name);
  visitor("definition", result.definition);
  visitor("value", result.value);
  visitor("text", result.text);
  visitor("expected_text", result.expected_text);
  visitor("unit", result.unit);
  visitor("low", result.low);
  visitor("high", result.high);
  visitor("uncertainty", result.uncertainty);
  visitor("judged", result.judged);
  visitor("verdict", result.verdict);
  visitor("reason", result.reason);
};

template <>
inline constexpr const char* table_name<Mark> = "mark";
template <>
inline constexpr auto visit_fields<Mark> = [](auto& mark, auto&& visitor) {
  visitor("tick", mark.tick);
  visitor("kind", mark.kind);
  visitor("value", mark.value);
  visitor("text", mark.text);
  visitor("by_outlet", mark.by_outlet);
};

template <>
inline constexpr const char* table_name<Sent> = "sent";
template <>
inline constexpr auto visit_fields<Sent> = [](auto& sent, auto&& visitor) {
  visitor("tick", sent.tick);
  visitor("kind", sent.kind);
  visitor("message", sent.message);
};

template <>
inline constexpr const char* table_name<AlignedClock> = "clock";
template <>
inline constexpr auto visit_fields<AlignedClock> = [](auto& clock, auto&& visitor) {
  visitor("what", clock.what);
  visitor("aligned_by", clock.aligned_by);
  visitor("uncertainty_ms", clock.uncertainty_ms);
};

template <>
inline constexpr const char* table_name<Comparison> = "comparison";
template <>
inline constexpr auto visit_fields<Comparison> = [](auto& comparison, auto&& visitor) {
  visitor("name", comparison.name);
  visitor("unit", comparison.unit);
  visitor("ours", comparison.ours);
  visitor("published", comparison.published);
  visitor("note", comparison.note);
};

template <>
inline constexpr const char* table_name<Series> = "series";
template <>
inline constexpr auto visit_fields<Series> = [](auto& series, auto&& visitor) {
  visitor("name", series.name);
  visitor("entries", series.entries);
  visitor("data", series.data);
};

template <>
inline constexpr const char* table_name<Seal> = "seal";
template <>
inline constexpr auto visit_fields<Seal> = [](auto& seal, auto&& visitor) {
  visitor("complete", seal.complete);
  visitor("sha256", seal.sha256);
};

// Traces: every field is a column, stored as a Series of that name.

template <>
inline constexpr auto visit_fields<MeasurementTrace> = [](auto& trace, auto&& visitor) {
  visitor("trace.tick", trace.tick);
  visitor("trace.frequency_hz", trace.frequency_hz);
  visitor("trace.rocof_hz_s", trace.rocof_hz_s);
  visitor("trace.voltage_pu", trace.voltage_pu);
  visitor("trace.validity", trace.validity);
};

template <>
inline constexpr auto visit_fields<EstimateTrace> = [](auto& trace, auto&& visitor) {
  visitor("estimates.tick", trace.tick);
  visitor("estimates.loss_mw", trace.loss_mw);
  visitor("estimates.loss_sigma_mw", trace.loss_sigma_mw);
  // Version 6 has no event_tick, and the loss's instant of the run in its place.
  visitor("estimates.event_tick", trace.event_tick);
  visitor("estimates.t_x_s", trace.loss_after_event_s);
  visitor("estimates.trusted", trace.trusted);
};

template <>
inline constexpr auto visit_fields<ReferenceTrace> = [](auto& trace, auto&& visitor) {
  visitor("reference.tick", trace.tick);
  visitor("reference.frequency_hz", trace.frequency_hz);
  visitor("reference.rocof_hz_s", trace.rocof_hz_s);
};

}  // namespace gsbench::record
