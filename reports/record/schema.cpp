#include "schema.hpp"

#include <utility>

namespace gsbench::record {
namespace {

using Names = std::set<std::string>;

constexpr const char* kIndex = "CREATE UNIQUE INDEX outlet_id ON \"outlet\" (id)";

// A NaN is stored as NULL, so only real numbers may be NULL.
template <class Field>
const char* column_type() {
  if constexpr (std::is_same_v<Field, std::string>) {
    return "TEXT NOT NULL";
  }
  if constexpr (std::is_same_v<Field, double>) {
    return "REAL";
  }
  if constexpr (std::is_same_v<Field, std::vector<std::uint8_t>>) {
    return "BLOB NOT NULL";
  }
  return "INTEGER NOT NULL";
}

// With the fields of these names only.
template <class Part>
std::string create_table(const Names& fields) {
  std::string sql = "CREATE TABLE \"" + std::string(table_name<Part>) +
                    "\" (owner INTEGER NOT NULL, position INTEGER NOT NULL";
  Part part;
  visit_fields<Part>(part, [&](const char* name, const auto& field) {
    if (fields.count(name) != 0) {
      using Field = std::decay_t<decltype(field)>;
      sql += ", \"" + std::string(name) + "\" " + column_type<Field>();
    }
  });
  return sql + ", PRIMARY KEY (owner, position)) STRICT";
}

struct Table {
  std::string name;
  Names fields;  // all of this version
  std::string (*create)(const Names& fields);
};

template <class Part>
Table table_of() {
  const std::vector<std::string> names = column_names<Part>();
  return {table_name<Part>, Names(names.begin(), names.end()), create_table<Part>};
}

const std::vector<Table>& tables() {
  static const std::vector<Table> all = {
      table_of<RunRecord>(),    table_of<AlignedClock>(), table_of<Comparison>(),
      table_of<OutletRecord>(), table_of<Setting>(),      table_of<MeasurementResult>(),
      table_of<Mark>(),         table_of<Sent>(),         table_of<Series>(),
      table_of<Seal>(),
  };
  return all;
}

std::int64_t checked_version(Database& database, std::int64_t newest) {
  if (database.first<std::int64_t>("PRAGMA application_id") != kApplicationId) {
    database.fail("not a gsbench record");
  }
  const auto version = database.first<std::int64_t>("PRAGMA user_version");
  if (version < kOldestVersion || version > newest) {
    database.fail("record of version " + std::to_string(version) +
                  "; this gsbench reads versions " + std::to_string(kOldestVersion) + " to " +
                  std::to_string(newest) + (version > newest ? ": use a newer gsbench" : ""));
  }
  return version;
}

Names names_in(Database& database, const std::string& sql, const std::string& parameter = "") {
  Statement statement = database.prepare(sql);
  if (!parameter.empty()) {
    statement.bind(1, parameter);
  }
  Names names;
  while (statement.step()) {
    std::string name;
    statement.get(0, name);
    names.insert(name);
  }
  return names;
}

template <class Trace>
void add_columns(Names& names) {
  for (const std::string& name : column_names<Trace>()) {
    names.insert(name);
  }
}

}  // namespace

std::string schema_sql() {
  std::string sql;
  for (const Table& table : tables()) {
    sql += table.create(table.fields) + ";\n";
  }
  return sql + kIndex + ";\n";
}

StoredFields::StoredFields(Database& database, std::int64_t newest)
    : version_(checked_version(database, newest)) {
  Names known = {kIndex};
  for (const Table& table : tables()) {
    const Names stored = names_in(database, "SELECT name FROM pragma_table_info(?)", table.name);
    if (!stored.empty()) {
      fields_[table.name] = stored;
      known.insert(table.create(stored));
    }
  }
  // SQLite's own objects have no text.
  if (names_in(database, "SELECT sql FROM sqlite_schema WHERE sql IS NOT NULL") != known) {
    database.fail("the record is damaged: its tables are not those of a record");
  }
  if (version_ == newest) {
    add_columns<ReferenceTrace>(columns_);
    add_columns<MeasurementTrace>(columns_);
    add_columns<EstimateTrace>(columns_);
  } else {
    columns_.merge(names_in(database, "SELECT DISTINCT name FROM series"));
  }
}

bool StoredFields::has(const std::string& table, const std::string& field) const {
  const auto found = fields_.find(table);
  return found != fields_.end() && found->second.count(field) != 0;
}

}  // namespace gsbench::record
