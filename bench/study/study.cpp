#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>

#include <judge/catalogue.hpp>
#include <station/run.hpp>
#include <study/study.hpp>

namespace gsbench::study {
namespace {

// What one seed adds; small, whatever the length of its run.
struct SeedResult {
  record::Verdict verdict = record::Verdict::kPass;
  std::string reason;
  std::vector<Row> rows;
  std::map<record::Verdict, std::size_t> verdicts;
};

Row& row_of(std::vector<Row>& rows, const record::MeasurementResult& result) {
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const Row& row) {
    return row.measure == result.name && row.unit == result.unit;
  });
  if (found != rows.end()) {
    return *found;
  }
  rows.push_back({result.name, result.unit, {}, {}});
  return rows.back();
}

void take(const record::OutletRecord& outlet, std::uint64_t seed, SeedResult& into) {
  ++into.verdicts[outlet.verdict];
  for (const record::MeasurementResult& result : outlet.measurements) {
    Row& row = row_of(into.rows, result);
    if (result.word.empty()) {
      row.values.add(result.value);
    } else {
      row.values.add_word(result.word);
    }
    if (!result.judged) {
      continue;
    }
    ++row.verdicts[result.verdict];
    if (result.verdict != record::Verdict::kPass && into.reason.empty()) {
      into.reason = "seed " + std::to_string(seed) + ", " + outlet.id + ", " + result.name + ": " +
                    result.reason;
    }
  }
}

SeedResult run_seed(profile::Plan plan, std::uint64_t seed, const std::atomic<bool>* stop) {
  plan.seed = seed;
  const std::unique_ptr<station::Station> station = station::simulated_station(plan, {});
  station::RunOptions options;
  options.stop = stop;
  const record::RunRecord run = station::run(plan, *station, options);
  SeedResult result;
  result.verdict = run.verdict;
  if (run.verdict == record::Verdict::kError) {
    result.reason = "seed " + std::to_string(seed) + ": " + run.verdict_reason;
  }
  for (const record::OutletRecord& outlet : run.outlets) {
    take(outlet, seed, result);
  }
  return result;
}

void merge(const SeedResult& seed, StudyResult& into) {
  into.verdict = std::max(into.verdict, seed.verdict);
  if (into.first_reason.empty()) {
    into.first_reason = seed.reason;
  }
  for (const auto& [verdict, count] : seed.verdicts) {
    into.verdicts[verdict] += count;
  }
  for (const Row& row : seed.rows) {
    const auto found = std::find_if(into.rows.begin(), into.rows.end(), [&](const Row& other) {
      return other.measure == row.measure && other.unit == row.unit;
    });
    if (found == into.rows.end()) {
      into.rows.push_back(row);
      continue;
    }
    found->values.merge(row.values);
    for (const auto& [verdict, count] : row.verdicts) {
      found->verdicts[verdict] += count;
    }
  }
}

std::size_t place_in_catalogue(const std::string& name) {
  const std::vector<judge::Measure>& all = judge::catalogue();
  return static_cast<std::size_t>(
      std::find_if(all.begin(), all.end(),
                   [&](const judge::Measure& measure) { return measure.name == name; }) -
      all.begin());
}

}  // namespace

StudyResult study(const profile::Plan& plan, const StudyOptions& options) {
  StudyResult study;
  // Merged in order of the seeds, so that threads leave no trace; those that ended before an
  // earlier one wait for it.
  std::map<std::uint64_t, SeedResult> waiting;
  std::mutex mutex;
  std::uint64_t merged = 0;
  std::uint64_t next = 0;
  std::uint64_t finished = 0;
  std::exception_ptr failure;
  const auto stopped = [&] { return options.stop != nullptr && options.stop->load(); };

  const auto work = [&] {
    std::unique_lock<std::mutex> lock(mutex);
    while (next < options.seeds && failure == nullptr && !stopped()) {
      const std::uint64_t index = next++;
      lock.unlock();
      SeedResult result;
      std::exception_ptr thrown;
      try {
        result = run_seed(plan, options.first_seed + index, options.stop);
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      failure = failure == nullptr ? thrown : failure;
      // A seed that was stopped half way says nothing.
      if (thrown == nullptr && !stopped()) {
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
    }
  };
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < options.threads; ++i) {
    helpers.emplace_back(work);
  }
  work();
  for (std::thread& helper : helpers) {
    helper.join();
  }
  if (failure != nullptr) {
    std::rethrow_exception(failure);
  }

  for (const auto& [index, result] : waiting) {
    merge(result, study);  // behind one that was stopped
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
    study.first_reason = "no seed was played to its end";
  }
  return study;
}

}  // namespace gsbench::study
