#include "kernel.hpp"

#include <outlet/conditions.hpp>
#include <outlet/loss_estimator.hpp>

// Each of them twice, for AVX2 and for any machine. Everything is inlined into the two, so that no
// code for the one is ever called by the other.
#define GSBENCH_FOR_ANY [[gnu::flatten]]
#define GSBENCH_FOR_AVX2 [[gnu::flatten, gnu::target("avx2")]]

namespace gsbench::campaign {
namespace {

using gs::outlet::LossEstimator;
using gs::outlet::LseState;
using gs::outlet::Settings;

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

// Runs beside fit_line() of the firmware: the same sums over the same window, oldest first.
inline void conditions_body(const Settings& settings, float nominal_hz,
                            const CountedConditions& counted, const float* deviations_hz,
                            float hits[kLanes]) {
  Lanes all{};
  for (int k = counted.first; k < counted.first + counted.count; ++k) {
    const auto at = [&](int sample) {
      return load(deviations_hz + static_cast<std::size_t>(sample) * kLanes);
    };
    const int oldest = k - counted.window + 1;
    const Lanes origin = at(oldest);
    LseState<Lanes> sums{};
    for (int sample = oldest; sample <= k; ++sample) {
      gs::outlet::add(sums, at(sample) - origin);
    }
    const Lanes mean_hz =
        origin + sums.sum * (1.0f / static_cast<float>(counted.window)) + nominal_hz;
    const Lanes limit = gs::outlet::rocof_limit_hz_s(settings, nominal_hz, mean_hz);
    all = all + select(gs::outlet::slope_hz_s(sums) < limit, Lanes{} + 1.0f, Lanes{});
  }
  store(all, hits);
}

// ---- for any machine

GSBENCH_FOR_ANY void outlet_any(const Settings& s, const gs::outlet::Response& r, const float* d,
                                int n, Estimates& e) {
  outlet_body(s, r, d, n, e);
}
GSBENCH_FOR_ANY void outlets_any(const Settings& s, const gs::outlet::ResponseOf<Lanes>& r,
                                 const float* d, int n, Estimates& e) {
  outlet_body(s, r, d, n, e);
}
GSBENCH_FOR_ANY void paper_any(const PaperStart& s, float k, const PaperModel<float>& m,
                               const float* d, int n, Estimates& e) {
  paper_body(s, k, m, d, n, e);
}
GSBENCH_FOR_ANY void papers_any(const PaperStart& s, float k, const PaperModel<Lanes>& m,
                                const float* d, int n, Estimates& e) {
  paper_body(s, k, m, d, n, e);
}
GSBENCH_FOR_ANY void conditions_any(const Settings& s, float f, const CountedConditions& c,
                                    const float* d, float* hits) {
  conditions_body(s, f, c, d, hits);
}

// ---- for AVX2

#if defined(__x86_64__)
GSBENCH_FOR_AVX2 void outlet_avx2(const Settings& s, const gs::outlet::Response& r, const float* d,
                                  int n, Estimates& e) {
  outlet_body(s, r, d, n, e);
}
GSBENCH_FOR_AVX2 void outlets_avx2(const Settings& s, const gs::outlet::ResponseOf<Lanes>& r,
                                   const float* d, int n, Estimates& e) {
  outlet_body(s, r, d, n, e);
}
GSBENCH_FOR_AVX2 void paper_avx2(const PaperStart& s, float k, const PaperModel<float>& m,
                                 const float* d, int n, Estimates& e) {
  paper_body(s, k, m, d, n, e);
}
GSBENCH_FOR_AVX2 void papers_avx2(const PaperStart& s, float k, const PaperModel<Lanes>& m,
                                  const float* d, int n, Estimates& e) {
  paper_body(s, k, m, d, n, e);
}
GSBENCH_FOR_AVX2 void conditions_avx2(const Settings& s, float f, const CountedConditions& c,
                                      const float* d, float* hits) {
  conditions_body(s, f, c, d, hits);
}
#endif

template <class Function>
Function* chosen(Function* any, Function* avx2) {
#if defined(__x86_64__)
  static const bool has_avx2 = __builtin_cpu_supports("avx2") != 0;
  return has_avx2 ? avx2 : any;
#else
  (void)avx2;
  return any;
#endif
}

}  // namespace

#if !defined(__x86_64__)
#define outlet_avx2 outlet_any
#define outlets_avx2 outlets_any
#define paper_avx2 paper_any
#define papers_avx2 papers_any
#define conditions_avx2 conditions_any
#endif

void estimate_as_outlet(const Settings& settings, const float* deviations_hz, int samples,
                        Estimates& estimates) {
  chosen(outlet_any, outlet_avx2)(settings, settings.response, deviations_hz, samples, estimates);
}

void estimate_as_outlet(const Settings& settings, const gs::outlet::ResponseOf<Lanes>& response,
                        const float* deviations_hz, int samples, Estimates& estimates) {
  chosen(outlets_any, outlets_avx2)(settings, response, deviations_hz, samples, estimates);
}

void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<float>& model, const float* deviations_hz, int samples,
                       Estimates& estimates) {
  chosen(paper_any, paper_avx2)(start, k_lse_mw_per_hz_s, model, deviations_hz, samples, estimates);
}

void estimate_as_paper(const PaperStart& start, float k_lse_mw_per_hz_s,
                       const PaperModel<Lanes>& model, const float* deviations_hz, int samples,
                       Estimates& estimates) {
  chosen(papers_any, papers_avx2)(start, k_lse_mw_per_hz_s, model, deviations_hz, samples,
                                  estimates);
}

void count_conditions(const Settings& settings, float nominal_hz, const CountedConditions& counted,
                      const float* deviations_hz, float hits[kLanes]) {
  chosen(conditions_any, conditions_avx2)(settings, nominal_hz, counted, deviations_hz, hits);
}

}  // namespace gsbench::campaign
