#include "schema.hpp"

#include <utility>

namespace gsbench::record {
namespace {

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

template <class Part>
std::string create_table() {
  std::string sql = "CREATE TABLE \"" + std::string(table_name<Part>) +
                    "\" (owner INTEGER NOT NULL, position INTEGER NOT NULL";
  Part part;
  visit_fields<Part>(part, [&](const char* name, const auto& field) {
    using Field = std::decay_t<decltype(field)>;
    sql += ", \"" + std::string(name) + "\" " + column_type<Field>();
  });
  return sql + ", PRIMARY KEY (owner, position)) STRICT;\n";
}

std::string tables_of(Database& database) {
  return database.first<std::string>(
      "SELECT group_concat(type || ' ' || name || ' ' || coalesce(sql, ''), char(10)) "
      "FROM (SELECT type, name, sql FROM sqlite_schema ORDER BY type, name)");
}

}  // namespace

std::string schema_sql() {
  return create_table<RunRecord>() + create_table<AlignedClock>() + create_table<Comparison>() +
         create_table<OutletRecord>() + create_table<Setting>() +
         create_table<MeasurementResult>() + create_table<Mark>() + create_table<Series>() +
         create_table<Seal>() + "CREATE UNIQUE INDEX outlet_id ON \"outlet\" (id);\n";
}

void check_schema(Database& database) {
  if (database.first<std::int64_t>("PRAGMA application_id") != kApplicationId) {
    database.fail("not a gsbench record");
  }
  const std::int64_t version = database.first<std::int64_t>("PRAGMA user_version");
  if (version != kSchemaVersion) {
    database.fail("record of version " + std::to_string(version) + "; this gsbench reads version " +
                  std::to_string(kSchemaVersion) +
                  (version > kSchemaVersion ? ": use a newer gsbench" : ""));
  }
  Database fresh = Database::in_memory();
  fresh.execute(schema_sql());
  if (tables_of(database) != tables_of(fresh)) {
    database.fail("the record is damaged: its tables are not those of a record");
  }
}

}  // namespace gsbench::record
