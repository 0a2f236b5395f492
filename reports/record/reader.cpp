#include "columns.hpp"
#include "schema.hpp"

#include <map>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using SeriesByName = std::map<std::string, Series>;

void mark_unfinished(RunRecord& run) {
  run.fault = "the run did not finish";
  run.verdict = Verdict::kError;
  run.verdict_reason = run.fault;
}

SeriesByName select_series(Database& database, std::int64_t owner) {
  SeriesByName by_name;
  for (Series& series : select<Series>(database, owner)) {
    const std::string name = series.name;
    by_name[name] = std::move(series);
  }
  return by_name;
}

template <class Trace>
void unpack_trace(const SeriesByName& series, Trace& trace) {
  visit_fields<Trace>(trace, [&](const char* name, auto& column) {
    const auto found = series.find(name);
    if (found == series.end()) {
      throw columns::DamagedColumn("column " + std::string(name) + " is missing");
    }
    columns::unpack(found->second.data, found->second.entries, column);
    if (column.size() != trace.tick.size()) {
      throw columns::DamagedColumn("column " + std::string(name) + " has a wrong length");
    }
  });
}

template <class Part>
Part select_one(Database& database, std::int64_t owner) {
  std::vector<Part> parts = select<Part>(database, owner);
  if (parts.size() != 1) {
    database.fail("the record is damaged: none or several rows in table " +
                  std::string(table_name<Part>));
  }
  return std::move(parts.front());
}

OutletRecord read_outlet(Database& database, std::int64_t owner) {
  auto outlet = select_one<OutletRecord>(database, owner);
  for (const Setting& setting : select<Setting>(database, owner)) {
    outlet.settings[setting.name] = setting.value;
  }
  outlet.measurements = select<MeasurementResult>(database, owner);
  outlet.marks = select<Mark>(database, owner);
  const SeriesByName series = select_series(database, owner);
  unpack_trace(series, outlet.trace);
  unpack_trace(series, outlet.estimates);
  if (select_one<Seal>(database, owner).sha256 != seal_of_outlet(outlet)) {
    database.fail("the record is damaged: the digest of an outlet does not match");
  }
  return outlet;
}

enum class Extent { kHead, kWhole };

RunRecord read_parts(Database& database, Extent extent) {
  if (database.first<std::int64_t>("SELECT count(*) FROM \"run\"") == 0) {
    RunRecord never_begun;
    mark_unfinished(never_begun);
    return never_begun;
  }
  auto run = select_one<RunRecord>(database, kRunOwner);
  run.clocks = select<AlignedClock>(database, kRunOwner);
  run.comparisons = select<Comparison>(database, kRunOwner);
  run.stimulus = select<Mark>(database, kRunOwner);
  unpack_trace(select_series(database, kRunOwner), run.reference);
  const auto seal = select_one<Seal>(database, kRunOwner);
  if (seal.sha256 != seal_of_run(run, seal.complete)) {
    database.fail("the record is damaged: the digest of the run does not match");
  }
  if (extent == Extent::kWhole) {
    const auto outlets = database.first<std::int64_t>("SELECT count(*) FROM \"outlet\"");
    for (std::int64_t owner = 1; owner <= outlets; ++owner) {
      run.outlets.push_back(read_outlet(database, owner));
    }
  }
  if (!seal.complete) {
    mark_unfinished(run);
  }
  return run;
}

RunRecord read(const std::string& path, Extent extent) {
  Database database(path, Database::Mode::kRead);
  database.execute("PRAGMA cell_size_check = ON");
  check_schema(database);
  // The whole file is checked only if all of it is read.
  if (extent == Extent::kWhole && database.first<std::string>("PRAGMA quick_check(1)") != "ok") {
    database.fail("the record is damaged");
  }
  // One transaction: of a run that is still being written a consistent state is read.
  database.execute("BEGIN");
  try {
    return read_parts(database, extent);
  } catch (const columns::DamagedColumn& damage) {
    database.fail("the record is damaged: " + std::string(damage.what()));
  }
}

}  // namespace

RunRecord read_run(const std::string& path) {
  return read(path, Extent::kWhole);
}

RunRecord read_head(const std::string& path) {
  return read(path, Extent::kHead);
}

}  // namespace gsbench::record
