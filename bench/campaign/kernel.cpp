#include <campaign/kernel.hpp>
#include <models/targets.hpp>
#include <outlet/conditions.hpp>
#include <outlet/loss_estimator.hpp>

namespace gsbench::campaign {

using gs::outlet::Settings;
using models::run_on_this_machine;

template <class Parameter>
Estimates estimate_as_outlet(const Settings& settings,
                             const gs::outlet::ResponseOf<Parameter>& response,
                             const float* deviations_hz) {
  Estimates estimates;
  run_on_this_machine([&] {
    gs::outlet::LossEstimator<Lanes> estimator{};
    for (std::size_t k = 0; k < kSamples; ++k) {
      gs::outlet::take(settings, response, estimator, load(deviations_hz + k * kLanes),
                       static_cast<int>(k));
    }
    store(estimator.lse_loss_mw, estimates.lse_mw);
    store(estimator.ekf.loss_mw, estimates.ekf_mw);
  });
  return estimates;
}

template Estimates estimate_as_outlet(const Settings&, const gs::outlet::ResponseOf<float>&,
                                      const float*);
template Estimates estimate_as_outlet(const Settings&, const gs::outlet::ResponseOf<Lanes>&,
                                      const float*);

template <class Parameter>
Estimates estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                            const PaperModel<Parameter>& model, const float* deviations_hz) {
  Estimates estimates;
  run_on_this_machine([&] {
    gs::outlet::LseState<Lanes> lse{};
    for (std::size_t k = 0; k < kLseSamples; ++k) {
      gs::outlet::add(lse, load(deviations_hz + k * kLanes));
    }
    const Lanes loss_mw = gs::outlet::slope_hz_s(lse) * k_lse_mw_per_hz_s;
    gs::outlet::EkfState<Lanes> ekf{};
    gs::outlet::start(start.ekf, ekf, loss_mw, Lanes{} + start.t_x_s);
    for (std::size_t k = kLseSamples; k < kSamples; ++k) {
      gs::outlet::update(start.ekf, model, ekf, load(deviations_hz + k * kLanes),
                         gs::outlet::kReport_s * static_cast<float>(k));
    }
    store(loss_mw, estimates.lse_mw);
    store(ekf.loss_mw, estimates.ekf_mw);
  });
  return estimates;
}

template Estimates estimate_as_paper(const PaperStart&, float, const PaperModel<float>&,
                                     const float*);
template Estimates estimate_as_paper(const PaperStart&, float, const PaperModel<Lanes>&,
                                     const float*);

void count_conditions(const Settings& settings, float nominal_hz, const Counting& counted,
                      const float* deviations_hz, float hits[kLanes]) {
  run_on_this_machine([&] {
    Lanes sum{};
    for (int k = counted.first; k < counted.first + counted.count; ++k) {
      auto line = gs::outlet::fit_line<Lanes>(
          [&](int back) {
            return load(deviations_hz + static_cast<std::size_t>(k - back) * kLanes);
          },
          counted.window);
      line.mean_hz = line.mean_hz + nominal_hz;
      const Mask met = gs::outlet::condition_met(settings, nominal_hz, line);
      sum = sum + select(met, Lanes{} + 1.0f, Lanes{});
    }
    store(sum, hits);
  });
}

void take_report(const Settings& settings, gs::outlet::LossEstimator<Lanes>& estimator,
                 const float deviation_hz[kLanes], int report) {
  run_on_this_machine([&] {
    gs::outlet::take(settings, settings.response, estimator, load(deviation_hz), report);
  });
}

}  // namespace gsbench::campaign
