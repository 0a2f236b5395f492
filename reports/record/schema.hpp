// The tables of a record file. A record consists of parts: outlets, measurements, marks, … Each
// kind of part has one table. The key of a row is the part's owner (0: the run, n: the n-th outlet)
// and its position among the owner's parts of this kind.
#pragma once

#include "fields.hpp"
#include "sqlite.hpp"

#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

namespace gsbench::record {

constexpr std::int64_t kApplicationId = 0x67734252;  // "gsBR": marks SQLite files that are records
constexpr std::int64_t kSchemaVersion = 6;  // increased whenever the text of the schema changes

constexpr std::int64_t kRunOwner = 0;

std::string schema_sql();

// Throws StoreError unless the file is a record of this version with exactly the expected tables.
// Nothing else is accepted, because a foreign view or trigger could run any SQL.
void check_schema(Database& database);

template <class Part>
std::string column_names() {
  std::string names;
  Part part;
  visit_fields<Part>(part, [&](const char* name, const auto&) {
    if (!names.empty()) {
      names += ", ";
    }
    names += '"' + std::string(name) + '"';
  });
  return names;
}

template <class Part>
void insert(Database& database, std::int64_t owner, const std::vector<Part>& parts) {
  int count = 2;
  Part empty;
  std::string places = "?, ?";
  visit_fields<Part>(empty, [&](const char*, const auto&) { places += ", ?"; });
  Statement statement =
      database.prepare("INSERT INTO \"" + std::string(table_name<Part>) + "\" (owner, position, " +
                       column_names<Part>() + ") VALUES (" + places + ")");
  std::int64_t position = 0;
  for (const Part& part : parts) {
    statement.bind(1, owner);
    statement.bind(2, position++);
    count = 2;
    visit_fields<Part>(part,
                       [&](const char*, const auto& field) { statement.bind(++count, field); });
    statement.step();
    statement.reset();
  }
}

template <class Part>
std::vector<Part> select(Database& database, std::int64_t owner) {
  Statement statement = database.prepare("SELECT " + column_names<Part>() + " FROM \"" +
                                         table_name<Part> + "\" WHERE owner = ? ORDER BY position");
  statement.bind(1, owner);
  std::vector<Part> parts;
  while (statement.step()) {
    Part part;
    int column = 0;
    visit_fields<Part>(part, [&](const char*, auto& field) { statement.get(column++, field); });
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace gsbench::record
