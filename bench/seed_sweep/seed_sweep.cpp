#include <seed_sweep/seed_sweep.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <set>
#include <utility>

#include <drivers/workers.hpp>
#include <measures/catalogue.hpp>
#include <station/run.hpp>

namespace gsbench::seed_sweep {
namespace {

Row& row_of(std::vector<Row>& rows, const std::string& measure, const std::string& unit) {
  const auto found = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& row) { return row.measure == measure; });
  if (found != rows.end()) {
    return *found;
  }
  rows.push_back({measure, unit, {}, {}, 0.0});
  return rows.back();
}

// A judged result is in the unit of its limit; the study uses the unit of the catalogue.
double scale_to(const std::string& unit, const record::MeasurementResult& result) {
  return measures::unit_scale(result.unit, unit).value_or(1.0);
}

void take(const record::OutletRecord& outlet, std::uint64_t seed, StudyResult& into) {
  ++into.verdicts[outlet.verdict];
  if (!outlet.fault.empty()) {
    into.first_reason = "seed " + std::to_string(seed) + ", " + outlet.id + " " + outlet.fault;
  }
  std::set<std::string> taken;
  for (const record::MeasurementResult& result : outlet.measurements) {
    const measures::Measure* measure = measures::find(result.name);
    Row& row = row_of(into.rows, result.name, measure != nullptr ? measure->unit : result.unit);
    // A measure with several limits has several results with the same value.
    if (taken.insert(result.name).second) {
      if (result.text.empty()) {
        const double scale = scale_to(row.unit, result);
        row.values.add(scale * result.value);
        row.uncertainty = std::fmax(row.uncertainty, scale * result.uncertainty);
      } else {
        row.values.add_text(result.text);
      }
    }
    if (!result.judged) {
      continue;
    }
    ++row.verdicts[result.verdict];
    if (result.verdict != record::Verdict::kPass && into.first_reason.empty()) {
      into.first_reason = "seed " + std::to_string(seed) + ", " + outlet.id + ", " + result.name +
                          ": " + result.reason;
    }
  }
}

// Runs one seed. The result is small, whatever the duration of the run.
StudyResult run_seed(profile::Plan plan, std::uint64_t seed, const std::atomic<bool>* stop) {
  plan.seed = seed;
  const std::unique_ptr<station::Station> station = station::simulated_station(plan, {});
  const record::RunRecord run = station::run(plan, *station, {nullptr, stop, {}});
  StudyResult result;
  result.verdict = run.verdict;
  if (run.verdict == record::Verdict::kError) {
    result.first_reason = "seed " + std::to_string(seed) + ": " + run.verdict_reason;
  }
  for (const record::OutletRecord& outlet : run.outlets) {
    take(outlet, seed, result);
  }
  return result;
}

void merge(const StudyResult& seed, StudyResult& into) {
  into.verdict = std::max(into.verdict, seed.verdict);
  if (into.first_reason.empty()) {
    into.first_reason = seed.first_reason;
  }
  for (const auto& [verdict, count] : seed.verdicts) {
    into.verdicts[verdict] += count;
  }
  for (const Row& row : seed.rows) {
    Row& all = row_of(into.rows, row.measure, row.unit);
    all.values.merge(row.values);
    all.uncertainty = std::fmax(all.uncertainty, row.uncertainty);
    for (const auto& [verdict, count] : row.verdicts) {
      all.verdicts[verdict] += count;
    }
  }
}

std::size_t place_in_catalogue(const std::string& name) {
  const std::vector<measures::Measure>& all = measures::catalogue();
  const measures::Measure* found = measures::find(name);
  return found == nullptr ? all.size() : static_cast<std::size_t>(found - all.data());
}

}  // namespace

StudyResult study(const profile::Plan& plan, const StudyOptions& options) {
  StudyResult study;
  // Results are merged in order of the seeds, so the number of threads does not matter. A seed that
  // ends before an earlier one waits here.
  std::map<std::uint64_t, StudyResult> waiting;
  std::mutex mutex;
  std::uint64_t merged = 0;
  std::uint64_t finished = 0;
  std::atomic<std::uint64_t> next{0};
  const auto stopped = [&] { return options.stop != nullptr && options.stop->load(); };
  // Work of one thread: runs seeds until none are left.
  const auto run_seeds = [&](std::size_t) {
    try {
      for (std::uint64_t index = next++; index < options.seeds && !stopped(); index = next++) {
        StudyResult result = run_seed(plan, options.first_seed + index, options.stop);
        const std::lock_guard<std::mutex> lock(mutex);
        if (stopped()) {
          return;  // an incomplete seed does not count
        }
        waiting.emplace(index, std::move(result));
        for (; waiting.count(merged) > 0; ++merged) {
          merge(waiting.at(merged), study);
          waiting.erase(merged);
        }
        ++finished;
        if (options.progress) {
          options.progress(finished, options.seeds);
        }
      }
    } catch (...) {
      next = options.seeds;  // the other threads start no more seeds
      throw;
    }
  };
  const std::size_t threads = std::max<std::size_t>(options.threads, 1);
  drivers::Workers(threads).run(threads, run_seeds);
  for (const auto& [index, result] : waiting) {
    merge(result, study);  // seeds after one that was stopped
  }
  study.seeds_done = finished;
  study.hours = static_cast<double>(finished) * static_cast<double>(plan.outlets.size()) *
                plan.stimulus.duration_s / 3600.0;
  std::stable_sort(study.rows.begin(), study.rows.end(), [](const Row& a, const Row& b) {
    return place_in_catalogue(a.measure) < place_in_catalogue(b.measure);
  });
  for (Row& row : study.rows) {
    row.values.sort();
  }
  if (finished == 0) {
    study.verdict = record::Verdict::kInconclusive;
    study.first_reason = "no seed was completed";
  }
  return study;
}

}  // namespace gsbench::seed_sweep
