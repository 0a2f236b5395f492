#include "read_parts.hpp"

#include "columns.hpp"
#include "seals.hpp"

#include <map>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using SeriesByName = std::map<std::string, Series>;

SeriesByName select_series(Database& database, const StoredFields& stored, std::int64_t owner,
                           std::int64_t append) {
  SeriesByName by_name;
  for (Series& series : select<Series>(database, stored, owner, append)) {
    const std::string name = series.name;
    by_name[name] = std::move(series);
  }
  return by_name;
}

// A column that the version of the file does not have is 0.
template <class Trace>
void unpack_trace(Database& database, const SeriesByName& series, const StoredFields& stored,
                  Trace& trace) {
  try {
    visit_fields<Trace>(trace, [&](const char* name, auto& column) {
      if (const auto found = series.find(name); found != series.end()) {
        columns::unpack(found->second.data, found->second.entries, column);
      }
      if (!stored.has_column(name)) {
        column.resize(trace.tick.size());
      }
      if (column.size() != trace.tick.size()) {
        throw columns::DamagedColumn("column " + std::string(name) +
                                     " is missing or has a wrong length");
      }
    });
  } catch (const columns::DamagedColumn& damage) {
    database.fail("the record is damaged: " + std::string(damage.what()));
  }
}

template <class Part>
Part select_one(Database& database, const StoredFields& stored, std::int64_t owner,
                std::int64_t append = 0) {
  std::vector<Part> parts = select<Part>(database, stored, owner, append);
  if (parts.size() != 1) {
    database.fail("the record is damaged: none or several rows in table " +
                  std::string(table_name<Part>));
  }
  return std::move(parts.front());
}

Reports read_append(Database& database, const StoredFields& stored, std::int64_t owner,
                    std::int64_t append) {
  Reports reports;
  reports.marks = select<Mark>(database, stored, owner, append);
  reports.sent = select<Sent>(database, stored, owner, append);
  const SeriesByName series = select_series(database, stored, owner, append);
  unpack_trace(database, series, stored, reports.trace);
  unpack_trace(database, series, stored, reports.estimates);
  return reports;
}

OutletRecord read_unsealed_results(Database& database, const StoredFields& stored,
                                   std::int64_t owner) {
  auto outlet = select_one<OutletRecord>(database, stored, owner);
  for (const Setting& setting : select<Setting>(database, stored, owner)) {
    outlet.settings[setting.name] = setting.value;
  }
  outlet.measurements = select<MeasurementResult>(database, stored, owner);
  return outlet;
}

void require_seal(Database& database, const std::string& stored, const std::string& computed,
                  const char* of) {
  if (stored != computed) {
    database.fail("the record is damaged: the digest of " + std::string(of) + " does not match");
  }
}

OutletRecord read_whole(Database& database, const StoredFields& stored, std::int64_t owner) {
  OutletRecord outlet = read_unsealed_results(database, stored, owner);
  outlet.reports = read_append(database, stored, owner, 0);
  require_seal(database, select_one<Seal>(database, stored, owner).sha256,
               seal_of_whole(outlet, stored), "an outlet");
  return outlet;
}

}  // namespace

std::string seals_of_outlets(Database& database) {
  Statement statement = database.prepare("SELECT sha256 FROM seal WHERE owner <> " +
                                         std::to_string(kRunOwner) + " ORDER BY owner, position");
  std::string all;
  while (statement.step()) {
    std::string seal;
    statement.get(0, seal);
    all += seal;
  }
  return all;
}

RunRecord read_head(Database& database, const StoredFields& stored, bool& complete) {
  auto run = select_one<RunRecord>(database, stored, kRunOwner);
  run.clocks = select<AlignedClock>(database, stored, kRunOwner);
  run.comparisons = select<Comparison>(database, stored, kRunOwner);
  run.stimulus = select<Mark>(database, stored, kRunOwner);
  unpack_trace(database, select_series(database, stored, kRunOwner, 0), stored, run.reference);
  const auto seal = select_one<Seal>(database, stored, kRunOwner);
  const bool covers_outlets = seal.complete && !stored.is_sealed_as_whole();
  require_seal(
      database, seal.sha256,
      seal_of_run(run, seal.complete, covers_outlets ? seals_of_outlets(database) : "", &stored),
      "the run");
  complete = seal.complete;
  return run;
}

OutletRecord read_results(Database& database, const StoredFields& stored, std::size_t number) {
  const auto owner = static_cast<std::int64_t>(number);
  if (stored.is_sealed_as_whole()) {
    OutletRecord outlet = read_whole(database, stored, owner);
    outlet.reports = {};
    return outlet;
  }
  OutletRecord outlet = read_unsealed_results(database, stored, owner);
  require_seal(database, select_one<Seal>(database, stored, owner).sha256,
               seal_of_results(outlet, &stored), "an outlet");
  return outlet;
}

OutletRecord read_marked(Database& database, const StoredFields& stored, std::size_t number) {
  OutletRecord outlet = read_results(database, stored, number);
  const auto owner = static_cast<std::int64_t>(number);
  outlet.reports.marks = select<Mark>(database, stored, owner, kAllAppends);
  outlet.reports.sent = select<Sent>(database, stored, owner, kAllAppends);
  return outlet;
}

void read_reports(Database& database, const StoredFields& stored, std::size_t number,
                  const TakeReports& take) {
  const auto owner = static_cast<std::int64_t>(number);
  if (stored.is_sealed_as_whole()) {
    take(read_whole(database, stored, owner).reports);
    return;
  }
  const auto appends = database.first<std::int64_t>("SELECT count(*) - 1 FROM seal WHERE owner = " +
                                                    std::to_string(owner));
  std::string seal;
  for (std::int64_t append = 0; append < appends; ++append) {
    const Reports reports = read_append(database, stored, owner, append);
    seal = seal_of_reports(seal, reports, &stored);
    require_seal(database, select_one<Seal>(database, stored, owner, append + 1).sha256, seal,
                 "reports");
    take(reports);
  }
}

}  // namespace gsbench::record
