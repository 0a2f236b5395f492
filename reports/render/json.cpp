#include <cmath>

#include <nlohmann/json.hpp>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json measurement(const record::MeasurementResult& result) {
  return {{"name", result.name},
          {"value", result.word.empty() ? number(result.value) : Json(result.word)},
          {"unit", result.unit},
          {"low", number(result.low)},
          {"high", number(result.high)},
          {"uncertainty", number(result.uncertainty)},
          {"verdict", record::to_string(result.verdict)}};
}

Json outlet(const record::OutletRecord& outlet) {
  Json measurements = Json::array();
  for (const record::MeasurementResult& result : outlet.measurements) {
    measurements.push_back(measurement(result));
  }
  return {{"id", outlet.id},
          {"verdict", record::to_string(outlet.verdict)},
          {"measurements", std::move(measurements)}};
}

}  // namespace

std::string json(const record::RunRecord& run) {
  Json outlets = Json::array();
  for (const record::OutletRecord& one : run.outlets) outlets.push_back(outlet(one));
  const Json whole = {{"run_id", run.run_id},
                      {"profile", run.profile},
                      {"profile_sha256", run.profile_sha256},
                      {"firmware_sha256", run.firmware_sha256},
                      {"seed", run.seed},
                      {"verdict", record::to_string(run.verdict)},
                      {"outlets", std::move(outlets)}};
  return whole.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace gsbench::render
