#include "record_view.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include <profile/load.hpp>

namespace gsbench::cli {
namespace {

// All outlets are stored at the same times, so that a few suffice.
constexpr std::size_t kMostAsked = 20;

std::string kept_until(const record::RunRecord& run, record::Reader& reader) {
  std::int64_t last_tick = -1;
  for (std::size_t i = 0; i < std::min(run.outlets.size(), kMostAsked); ++i) {
    reader.read_reports(i, [&](const record::Reports& piece) {
      if (!piece.trace.tick.empty()) {
        last_tick = std::max(last_tick, piece.trace.tick.back());
      }
    });
  }
  return last_tick < 0 || run.sample_rate_hz == 0
             ? "; no measurement was kept"
             : fmt::format("; measurements were kept up to {:.3f} s of {:.3f} s",
                           static_cast<double>(last_tick) / static_cast<double>(run.sample_rate_hz),
                           static_cast<double>(run.duration_ticks) /
                               static_cast<double>(run.sample_rate_hz));
}

[[noreturn]] void refuse(const record::RunRecord& run, const std::string& id) {
  constexpr std::size_t kMostListed = 10;
  std::string ids;
  for (std::size_t i = 0; i < std::min(run.outlets.size(), kMostListed); ++i) {
    ids += (i == 0 ? "" : ", ") + run.outlets[i].id;
  }
  if (run.outlets.size() > kMostListed) {
    ids += fmt::format(", … ({} in all; `gsbench report {} --format json` lists them)",
                       run.outlets.size(), run.run_id);
  }
  throw profile::ConfigurationError(
      fmt::format("--outlet {}: the run has no outlet with this id; {}", id,
                  ids.empty() ? "it has no outlets" : "its outlets are " + ids));
}

std::vector<std::size_t> indices_of(const record::RunRecord& run,
                                    const std::vector<std::string>& ids) {
  std::vector<std::size_t> indices;
  for (const std::string& id : ids) {
    const auto found = std::find_if(run.outlets.begin(), run.outlets.end(),
                                    [&](const auto& outlet) { return outlet.id == id; });
    if (found == run.outlets.end()) {
      refuse(run, id);
    }
    const auto index = static_cast<std::size_t>(found - run.outlets.begin());
    if (std::find(indices.begin(), indices.end(), index) == indices.end()) {
      indices.push_back(index);
    }
  }
  return indices;
}

}  // namespace

record::RunRecord results_of(record::Reader& reader) {
  record::RunRecord run = record::read_results(reader);
  const bool has_finished = !run.interrupted || !run.finished_utc.empty();
  if (!has_finished) {
    run.verdict_reason += kept_until(run, reader);
  }
  return run;
}

render::View view_of(const record::RunRecord& run, record::Reader& reader,
                     const std::vector<std::string>& ids) {
  render::View view = run;
  // An outlet has no reports if the disk was full before it was stored.
  view.marked = [&run, &reader](std::size_t index) {
    record::OutletRecord outlet = run.outlets[index];
    if (index < reader.outlets()) {
      outlet.reports = reader.marked(index).reports;
    }
    return outlet;
  };
  view.read_reports = [&reader](std::size_t index, const record::TakeReports& take) {
    if (index < reader.outlets()) {
      reader.read_reports(index, take);
    }
  };
  if (!ids.empty()) {
    view.outlets = indices_of(run, ids);
  }
  return view;
}

}  // namespace gsbench::cli
