#include "read_parts.hpp"

#include <filesystem>
#include <optional>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

constexpr const char* kUnfinished =
    "interrupted: the run did not finish; gsbench was ended, or is still playing it";

constexpr const char* kWithoutRun =
    "interrupted: the record holds no run; gsbench was ended before it stored one, or the file "
    "beside the record whose name ends in -wal is missing or damaged";

void mark_unfinished(RunRecord& run) {
  run.interrupted = run.interrupted || run.fault.empty();
  if (run.fault.empty()) {
    run.fault = kUnfinished;
  }
  run.verdict = Verdict::kError;
  run.verdict_reason = run.fault;
}

}  // namespace

struct Reader::Impl {
  explicit Impl(const std::string& path) : database(path, Database::Mode::kRead) {
    std::error_code error;
    if (std::filesystem::file_size(path, error) == 0 && !error) {
      mark_unfinished(head);  // killed before it wrote anything
      return;
    }
    database.execute("PRAGMA cell_size_check = ON");
    stored.emplace(database);
    // One transaction: of a run that is still being written a consistent state is read.
    database.execute("BEGIN");
    if (database.first<std::int64_t>("SELECT count(*) FROM \"run\"") != 0) {
      head = read_head(database, *stored, complete);
    } else {
      head.interrupted = true;
      head.fault = kWithoutRun;
    }
    if (!complete) {
      mark_unfinished(head);
    }
    outlets =
        static_cast<std::size_t>(database.first<std::int64_t>("SELECT count(*) FROM \"outlet\""));
  }

  // Outlets are judged at the end of a run. If it then fails, some have been stored with results.
  OutletRecord judged(OutletRecord outlet) const {
    if (!complete || !is_judged(head)) {
      outlet.verdict = Verdict::kError;
      outlet.measurements.clear();
    }
    return outlet;
  }

  Database database;
  std::optional<StoredFields> stored;
  bool complete = false;
  RunRecord head;
  std::size_t outlets = 0;
};

Reader::Reader(const std::string& path) : impl_(std::make_unique<Impl>(path)) {}
Reader::~Reader() = default;

const RunRecord& Reader::head() const {
  return impl_->head;
}

std::size_t Reader::outlets() const {
  return impl_->outlets;
}

OutletRecord Reader::results(std::size_t i) {
  return impl_->judged(read_results(impl_->database, *impl_->stored, i + 1));
}

OutletRecord Reader::marked(std::size_t i) {
  OutletRecord outlet = impl_->judged(read_marked(impl_->database, *impl_->stored, i + 1));
  place_on_run_time(outlet.reports, outlet.clock, impl_->head.duration_ticks);
  return outlet;
}

OutletRecord Reader::outlet(std::size_t i) {
  OutletRecord outlet = results(i);
  record::read_reports(impl_->database, *impl_->stored, i + 1,
                       [&](const Reports& piece) { outlet.reports.append(piece); });
  place_on_run_time(outlet.reports, outlet.clock, impl_->head.duration_ticks);
  return outlet;
}

void Reader::check() {
  for (std::size_t i = 0; i < impl_->outlets; ++i) {
    record::read_reports(impl_->database, *impl_->stored, i + 1, [](const Reports&) {});
  }
}

void Reader::read_reports(std::size_t i, const TakeReports& take) {
  const Clock clock = results(i).clock;
  record::read_reports(impl_->database, *impl_->stored, i + 1, [&](const Reports& piece) {
    Reports placed = piece;
    place_on_run_time(placed, clock, impl_->head.duration_ticks);
    take(placed);
  });
}

RunRecord read_run(const std::string& path) {
  Reader reader(path);
  RunRecord run = reader.head();
  for (std::size_t i = 0; i < reader.outlets(); ++i) {
    run.outlets.push_back(reader.outlet(i));
  }
  if (run.content_sha256.empty() && !run.interrupted) {
    run.content_sha256 = content_digest(run);
  }
  return run;
}

RunRecord read_results(Reader& reader) {
  RunRecord run = reader.head();
  ContentDigest digest;
  const bool has_digest = !run.content_sha256.empty() || run.interrupted;
  for (std::size_t i = 0; i < reader.outlets(); ++i) {
    run.outlets.push_back(reader.results(i));
    if (!has_digest) {
      // Of version 6, which has neither the digest nor this measurement.
      OutletRecord outlet = reader.outlet(i);
      digest.add_traces(outlet.reports);
      digest.add_outlet(outlet);
      if (find_measurement(outlet, "decision.trust") == nullptr) {
        run.outlets.back().reports.marks = std::move(outlet.reports.marks);
      }
    }
  }
  if (!has_digest) {
    run.content_sha256 = digest.of(run);
  }
  return run;
}

RunRecord read_head(const std::string& path) {
  return Reader(path).head();
}

}  // namespace gsbench::record
