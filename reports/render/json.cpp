#include "format.hpp"
#include "json_text.hpp"
#include "kept.hpp"
#include "summary.hpp"

#include <render/render.hpp>

namespace gsbench::render {
namespace {

Json text_or_null(const std::string& text) {
  return text.empty() ? Json(nullptr) : Json(text);
}

Json measurement(const record::MeasurementResult& result) {
  return {{"name", result.name},
          {"value", result.text.empty() ? Json(result.value) : Json(result.text)},
          {"unit", result.unit},
          {"low", result.low},
          {"high", result.high},
          {"uncertainty", result.uncertainty},
          {"judged", result.judged},
          {"expected_text", text_or_null(result.expected_text)},
          {"verdict", result.judged ? Json(record::to_string(result.verdict)) : Json(nullptr)},
          {"reason", result.reason}};
}

Json outlet(const record::OutletRecord& outlet) {
  const auto if_known = [&](std::uint64_t number) {
    return has_sent_hello(outlet) ? Json(number) : Json(nullptr);
  };
  return {{"id", outlet.id},
          {"group", outlet.group},
          {"link", outlet.link},
          {"board", text_or_null(outlet.board)},
          {"instance", if_known(outlet.instance)},
          {"firmware", text_or_null(outlet.firmware)},
          {"build", text_or_null(outlet.build)},
          {"protocol_version", if_known(outlet.protocol_version)},
          {"settings_digest", text_or_null(outlet.settings_digest)},
          {"verdict", record::to_string(outlet.verdict)},
          {"fault", text_or_null(outlet.fault)},
          {"clock",
           {{"drift_ppm", outlet.clock.drift_ppm},
            {"drift_uncertainty_ppm", outlet.clock.drift_uncertainty_ppm},
            {"uncertainty_ms", outlet.clock.uncertainty_ms}}},
          {"measurements", array_of(outlet.measurements, measurement)}};
}

Json clock(const record::AlignedClock& clock) {
  return {{"what", clock.what},
          {"aligned_by", clock.aligned_by},
          {"uncertainty_ms", clock.uncertainty_ms}};
}

Json source(const record::RunRecord& run) {
  return {{"name", run.source.name},
          {"how", run.source.how},
          {"accuracy", text_or_null(run.source.accuracy)},
          {"frequency_mhz", run.bench_uncertainty.frequency_mhz},
          {"voltage_pct", run.bench_uncertainty.voltage_pct},
          {"time_ms", run.bench_uncertainty.time_ms}};
}

Json column(const std::string& column) {
  const std::optional<std::uint64_t> number = column_number(column);
  return number ? Json(*number) : text_or_null(column);
}

// Texts, numbers and arrays are the same in TOML and JSON.
Json options_of(const record::Recording& recording) {
  Json options = Json::object();
  for (const auto& [key, value] : recording_options(recording)) {
    const Json read = Json::parse(value, nullptr, false);
    options[key] = read.is_discarded() ? Json(value) : read;
  }
  return options;
}

Json recording(const record::RunRecord& run) {
  const record::Recording& recording = run.recording;
  if (recording.file.empty()) {
    return nullptr;
  }
  return {{"file", recording.file},
          {"sha256", recording.sha256},
          {"time", column(recording.time)},
          {"frequency", column(recording.frequency)},
          {"voltage", column(recording.voltage)},
          {"nominal_voltage",
           recording.nominal_voltage > 0.0 ? Json(recording.nominal_voltage) : Json(nullptr)},
          {"replaces_profile", recording.replaces_profile},
          {"options", options_of(recording)},
          {"rows", recording.rows > 0 ? Json(recording.rows) : Json(nullptr)},
          {"gaps", recording.rows > 0 ? Json(recording.gaps) : Json(nullptr)},
          {"played_s",
           static_cast<double>(run.duration_ticks) / static_cast<double>(run.sample_rate_hz)}};
}

Json kept_json(const record::RunRecord& run, const Kept& kept) {
  return {{"measurements", kept.measurements},
          {"until_s", kept.measurements == 0 ? Json(nullptr) : Json(seconds(run, kept.last_tick))},
          {"marks", array_of(kept.marks, [&](const record::Mark& mark) {
             return Json{{"t_s", seconds(run, mark.tick)},
                         {"kind", mark.kind},
                         {"value", mark.value},
                         {"text", mark.text}};
           })}};
}

}  // namespace

// Outlet by outlet: the values of all outlets would take more memory than their text.
std::string json(const View& view) {
  const record::RunRecord& run = view.run;
  std::string text = indented({{"format_version", record::kFormatVersion},
                               {"run_id", run.run_id},
                               {"profile", run.profile},
                               {"profile_sha256", run.profile_sha256},
                               {"grid", run.grid},
                               {"grid_sha256", text_or_null(run.grid_sha256)},
                               {"recording", recording(run)},
                               {"firmware_sha256", run.firmware_sha256},
                               {"gsbench_version", run.gsbench_version},
                               {"software", text_or_null(run.software)},
                               {"seed", run.seed},
                               {"source", source(run)},
                               {"clocks", array_of(run.clocks, clock)},
                               {"interrupted", run.interrupted},
                               {"fault", text_or_null(run.fault)},
                               {"verdict", record::to_string(run.verdict)},
                               {"verdict_reason", run.verdict_reason}});
  text.resize(text.rfind("\n}"));
  text += ",\n  \"outlets\": [";
  const char* before = "\n";
  for (const std::size_t index : view.outlets) {
    Json entry = outlet(run.outlets[index]);
    entry["kept"] = is_judged(run) ? Json(nullptr) : kept_json(run, kept_of(view, index));
    text += before + indented(entry, 4);
    before = ",\n";
  }
  return text + (view.outlets.empty() ? "]\n}\n" : "\n  ]\n}\n");
}

}  // namespace gsbench::render
