// One plan run over many seeds on simulated stations: how its measurements are distributed.
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
  std::function<void(std::uint64_t done, std::uint64_t all)> progress;  // from any thread, in turn
};

// One measure: a value of each outlet and seed, and beside them what each limit on it came to.
struct Row {
  std::string measure;
  std::string unit;  // the catalogue's
  Distribution values;
  std::map<record::Verdict, std::size_t> verdicts;  // of outlets, seeds and limits
};

struct StudyResult {
  std::uint64_t seeds_done = 0;
  double hours = 0.0;     // outlet time played: seeds · duration · outlets
  std::vector<Row> rows;  // in the catalogue's order
  std::map<record::Verdict, std::size_t> verdicts;  // of outlets
  record::Verdict verdict = record::Verdict::kPass;
  std::string first_reason;  // of the first outlet that did not pass, by seed
};

// The same for any number of threads. Rethrows what a run throws.
StudyResult study(const profile::Plan& plan, const StudyOptions& options);

}  // namespace gsbench::seed_sweep
