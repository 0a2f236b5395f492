#include <campaign/kernel.hpp>
#include <models/targets.hpp>
#include <outlet/conditions.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {
namespace {

using gs::outlet::LossEstimator;
using gs::outlet::LseState;
using gs::outlet::Settings;
using models::run_on_this_machine;

template <class Model>
inline void outlet_body(const Settings& settings, const Model& response, const float* deviations_hz,
                        int samples, Estimates& estimates) {
  LossEstimator<Lanes> estimator{};
  for (int k = 0; k < samples; ++k) {
    gs::outlet::take(settings, response, estimator,
                     load(deviations_hz + static_cast<std::size_t>(k) * kLanes), k);
  }
  store(estimator.lse_loss_mw, estimates.lse_mw);
  store(estimator.ekf.loss_mw, estimates.ekf_mw);
}

template <class Model>
inline void paper_body(const PaperStart& start, float k_lse_mw_per_hz_s, const Model& model,
                       const float* deviations_hz, int samples, Estimates& estimates) {
  LseState<Lanes> lse{};
  for (int k = 0; k < start.lse_samples; ++k) {
    gs::outlet::add(lse, load(deviations_hz + static_cast<std::size_t>(k) * kLanes));
  }
  const Lanes loss_mw = gs::outlet::slope_hz_s(lse) * k_lse_mw_per_hz_s;
  gs::outlet::EkfState<Lanes> ekf{};
  gs::outlet::start(start.ekf, ekf, loss_mw, Lanes{} + start.t_x_s);
  for (int k = start.lse_samples; k < samples; ++k) {
    gs::outlet::update(start.ekf, model, ekf,
                       load(deviations_hz + static_cast<std::size_t>(k) * kLanes),
                       gs::outlet::kReportS * static_cast<float>(k));
  }
  store(loss_mw, estimates.lse_mw);
  store(ekf.loss_mw, estimates.ekf_mw);
}

inline void conditions_body(const Settings& settings, float nominal_hz,
                            const CountedConditions& counted, const float* deviations_hz,
                            float hits[kLanes]) {
  Lanes sum{};
  for (int k = counted.first; k < counted.first + counted.count; ++k) {
    auto line = gs::outlet::fit_line<Lanes>(
        [&](int back) { return load(deviations_hz + static_cast<std::size_t>(k - back) * kLanes); },
        counted.window);
    line.mean_hz = line.mean_hz + nominal_hz;
    const Mask met = gs::outlet::condition_met(settings, nominal_hz, line);
    sum = sum + select(met, Lanes{} + 1.0f, Lanes{});
  }
  store(sum, hits);
}

}  // namespace

void estimate_as_outlet(const Settings& settings, const float* deviations_hz, int samples,
                        Estimates& estimates) {
  run_on_this_machine(
      [&] { outlet_body(settings, settings.response, deviations_hz, samples, estimates); });
}

void estimate_as_outlet(const Settings& settings, const gs::outlet::ResponseOf<Lanes>& response,
                        const float* deviations_hz, int samples, Estimates& estimates) {
  run_on_this_machine([&] { outlet_body(settings, response, deviations_hz, samples, estimates); });
}

void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<float>& model, const float* deviations_hz, int samples,
                       Estimates& estimates) {
  run_on_this_machine(
      [&] { paper_body(start, k_lse_mw_per_hz_s, model, deviations_hz, samples, estimates); });
}

void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<Lanes>& model, const float* deviations_hz, int samples,
                       Estimates& estimates) {
  run_on_this_machine(
      [&] { paper_body(start, k_lse_mw_per_hz_s, model, deviations_hz, samples, estimates); });
}

void count_conditions(const Settings& settings, float nominal_hz, const CountedConditions& counted,
                      const float* deviations_hz, float hits[kLanes]) {
  run_on_this_machine([&] { conditions_body(settings, nominal_hz, counted, deviations_hz, hits); });
}

void take_report(const Settings& settings, LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report) {
  run_on_this_machine([&] {
    gs::outlet::take(settings, settings.response, estimator, load(deviation_hz), report);
  });
}

}  // namespace gsbench::campaign
