#include "claim.hpp"
#include "random_grids.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

namespace gsbench::oracle {
namespace {

// The closed forms have relative rounding errors of about 1e-14. The largest error is that of f: a
// double near 50 Hz is rounded to 4e-15 Hz, up to 2e-13 of the smallest deviation of these grids.
constexpr double kTolerance = 1e-12;

Scenario scenario_on(const grid::Grid& grid, RandomGrids& random) {
  Scenario scenario{grid, random.changes(grid), {}};
  for (int i = 0; i <= 60; ++i) {
    scenario.times_s.push_back(0.25 * i);
  }
  return scenario;
}

// Down to 1e-15 around zeta = 1, where rounding decides which closed form applies.
double distance_to_critical(int i) {
  return std::pow(10.0, -(i % 16));
}

TEST(GridAgreement, HoldsForAThousandRandomGridsOfAnyDamping) {
  RandomGrids random(20'250'428);
  int underdamped = 0, overdamped = 0, nearly_critical = 0, without_nadir = 0;
  for (int i = 0; i < 1000; ++i) {
    const grid::Grid grid = i % 10 == 0  ? random.without_reheat()
                            : i % 2 == 0 ? random.any()
                                         : random.nearly_critical(distance_to_critical(i / 2));
    const Scenario scenario = scenario_on(grid, random);
    const Claim claim = claim_of(scenario);
    const Disagreement by = compare(scenario, claim);
    const double zeta = grid::SfrModel(grid).zeta();
    EXPECT_LT(by.worst(), kTolerance)
        << "grid " << i << ", zeta " << zeta << ": deviation " << by.deviation << ", ROCOF "
        << by.rocof << ", phase " << by.phase << ", nadir " << by.nadir << " at " << by.nadir_time
        << ", threshold " << by.threshold << ", K_LSE " << by.k_lse << ", conditions "
        << by.conditions;
    if (std::abs(zeta - 1.0) < 1e-6) {
      ++nearly_critical;
    } else {
      ++(zeta < 1.0 ? underdamped : overdamped);
    }
    if (std::isinf(claim.nadir.t_s)) {
      ++without_nadir;
    }
  }
  // Each case of the closed forms was tested often enough.
  EXPECT_GT(underdamped, 200);
  EXPECT_GT(overdamped, 200);
  EXPECT_GT(nearly_critical, 200);
  EXPECT_GT(without_nadir, 50);
}

using Spoil = std::function<void(const Scenario&, Claim&)>;

// A wrong claim for each figure that is compared.
struct Mutant {
  const char* name;
  Spoil spoil;
  double Disagreement::*shows_in;
};

// Replaces the deviation by a superposition of a given unit response, Hz/MW.
Spoil with_unit_response(double (*unit_hz)(const grid::SfrModel&, double)) {
  return [unit_hz](const Scenario& scenario, Claim& claim) {
    const grid::SfrModel model(scenario.grid);
    for (std::size_t i = 0; i < scenario.times_s.size(); ++i) {
      double sum_hz = 0.0;
      for (const grid::PowerChange& change : scenario.changes) {
        const double since_s = scenario.times_s[i] - change.at_s;
        if (since_s >= 0.0) {
          sum_hz += change.power_mw * unit_hz(model, since_s);
        }
      }
      claim.courses[i].deviation_hz = sum_hz;
    }
  };
}

double response_hz(const grid::SfrModel& model, double sigma, double t_s) {
  const double omega_r = std::sqrt(model.omega_n() * model.omega_n() - sigma * sigma);
  return -model.gain_hz_per_mw() *
         (1.0 + std::exp(-sigma * t_s) *
                    ((model.initial_slope_per_s() - sigma) / omega_r * std::sin(omega_r * t_s) -
                     std::cos(omega_r * t_s)));
}

Spoil of_another_grid(void (*change)(grid::Grid&)) {
  return [change](const Scenario& scenario, Claim& claim) {
    Scenario other = scenario;
    change(other.grid);
    claim = claim_of(other);
  };
}

const Mutant kMutants[] = {
    {"DampingAsMisprintedInEquationThree",
     with_unit_response([](const grid::SfrModel& model, double t_s) {
       return response_hz(model, 0.5 * model.sigma_per_s(), t_s);
     }),
     &Disagreement::deviation},
    {"ArctangentsOfEquationNineInTheWrongQuadrant",
     with_unit_response([](const grid::SfrModel& model, double t_s) {
       return -2.0 * model.gain_hz_per_mw() - response_hz(model, model.sigma_per_s(), t_s);
     }),
     &Disagreement::deviation},
    {"InertiaWrongByABillionth",
     of_another_grid([](grid::Grid& g) { g.plants[0].inertia_s *= 1.0 + 1e-9; }),
     &Disagreement::rocof},
    {"ReheatFractionWrongByABillionth",
     of_another_grid([](grid::Grid& g) { g.reheat_fraction *= 1.0 + 1e-9; }), &Disagreement::nadir},
    {"DroopNotScaledToThePlantRating", of_another_grid([](grid::Grid& g) {
       for (grid::Plant& plant : g.plants) {
         plant.droop_pu *= g.base_mw / plant.rating_mw;
       }
     }),
     &Disagreement::threshold},
    {"PhaseWithoutTheTransient",
     [](const Scenario& scenario, Claim& claim) {
       const double end_hz_per_mw = grid::SfrModel(scenario.grid).gain_hz_per_mw();
       for (std::size_t i = 0; i < claim.courses.size(); ++i) {
         claim.courses[i].excess_cycles = 0.0;
         for (const grid::PowerChange& change : scenario.changes) {
           claim.courses[i].excess_cycles -=
               change.power_mw * end_hz_per_mw * std::max(0.0, scenario.times_s[i] - change.at_s);
         }
       }
     },
     &Disagreement::phase},
    {"NadirAtTheNextBranchOfTheArctangent",
     [](const Scenario& scenario, Claim& claim) {
       claim.nadir.t_s += M_PI / std::sqrt(grid::SfrModel(scenario.grid).discriminant_per_s2());
     },
     &Disagreement::nadir_time},
    {"NoNadir",
     [](const Scenario&, Claim& claim) {
       claim.nadir.t_s = std::numeric_limits<double>::infinity();
     },
     &Disagreement::nadir_time},
    {"ThresholdFromTheFinalValueInsteadOfTheNadir",
     [](const Scenario& scenario, Claim& claim) {
       claim.threshold_mw = (scenario.grid.nominal_hz - scenario.grid.threshold_hz) /
                            grid::SfrModel(scenario.grid).gain_hz_per_mw();
     },
     &Disagreement::threshold},
    {"LseConstantWithTheWrongSign",
     [](const Scenario&, Claim& claim) { claim.k_lse_mw_per_hz_s *= -1.0; }, &Disagreement::k_lse},
    {"ConditionsAtTheUpperEdges",
     [](const Scenario&, Claim& claim) {
       for (std::size_t i = claim.conditions.size() - 1; i > 0; --i) {
         claim.conditions[i].rocof_below_hz_s = claim.conditions[i - 1].rocof_below_hz_s;
       }
     },
     &Disagreement::conditions},
    {"ConditionIsNaN",
     [](const Scenario&, Claim& claim) { claim.conditions[1].rocof_below_hz_s = std::nan(""); },
     &Disagreement::conditions},
};

TEST(GridAgreement, DetectsEachMutant) {
  RandomGrids random(7);
  grid::Grid grid = random.any();
  // Underdamped, as the publication's equations require, and with more than one plant.
  while (grid::SfrModel(grid).zeta() > 0.9 || grid.plants.size() < 2) {
    grid = random.any();
  }
  const Scenario scenario = scenario_on(grid, random);
  const Claim correct = claim_of(scenario);
  ASSERT_GT(correct.conditions.size(), 2u);
  ASSERT_LT(compare(scenario, correct).worst(), kTolerance);
  for (const Mutant& mutant : kMutants) {
    Claim claim = correct;
    mutant.spoil(scenario, claim);
    EXPECT_GT(compare(scenario, claim).*mutant.shows_in, 10.0 * kTolerance) << mutant.name;
  }
}

}  // namespace
}  // namespace gsbench::oracle
