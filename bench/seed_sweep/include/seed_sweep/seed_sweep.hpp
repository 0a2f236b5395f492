// Runs one plan with many seeds on simulated stations and collects its measurements.
#pragma once

#include <seed_sweep/distribution.hpp>

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <profile/plan.hpp>
#include <record/run_record.hpp>

namespace gsbench::seed_sweep {

struct StudyOptions {
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 1;
  std::size_t threads = 1;
  const std::atomic<bool>* stop = nullptr;
  // Called after each seed, from any thread, but never by two threads at once.
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;
};

// One measure: its value for each outlet and seed, and the verdicts on its limits.
struct Row {
  std::string measure;
  std::string unit;  // as in the catalogue
  Distribution values;
  std::map<record::Verdict, std::size_t> verdicts;  // one for each outlet, seed and limit
  double uncertainty = 0.0;  // largest expanded uncertainty (k = 2) of the values, in `unit`
};

struct StudyResult {
  std::uint64_t seeds_done = 0;
  double hours = 0.0;                               // outlet hours: seeds · duration · outlets
  std::vector<Row> rows;                            // in the catalogue's order
  std::map<record::Verdict, std::size_t> verdicts;  // of outlets
  record::Verdict verdict = record::Verdict::kPass;
  std::string first_reason;  // of the first outlet that did not pass, in order of seeds
};

// Blocks until all seeds are done or `stop` is set. The result does not depend on the number of
// threads. Rethrows the first exception of a run.
StudyResult study(const profile::Plan& plan, const StudyOptions& options);

}  // namespace gsbench::seed_sweep
