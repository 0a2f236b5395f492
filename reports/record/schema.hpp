// The tables of a record file. A record consists of parts: outlets, measurements, marks, … Each
// kind of part has one table. The key of a row is the part's owner (0: the run, n: the n-th outlet)
// and its position among the owner's parts of this kind. Parts of the n-th append, from 0, have the
// positions from n · kAppendPositions on.
#pragma once

#include "fields.hpp"
#include "sqlite.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <type_traits>
#include <vector>

namespace gsbench::record {

constexpr std::int64_t kApplicationId = 0x67734252;  // "gsBR": marks SQLite files that are records
// Increased whenever the text of the schema changes. Records of all versions from the oldest on are
// read: what a version does not have takes its default. Fields are only added.
constexpr std::int64_t kSchemaVersion = kFormatVersion;
constexpr std::int64_t kOldestVersion = 6;

constexpr std::int64_t kRunOwner = 0;
constexpr std::int64_t kAppendPositions = std::int64_t{1} << 32;

std::string schema_sql();

// The fields that a file has.
class StoredFields {
 public:
  // Throws StoreError unless the file is a record of a known version. It may have the expected
  // tables and columns only, because a foreign view or trigger could run any SQL. Files of versions
  // before `newest` have the columns of traces that they contain.
  explicit StoredFields(Database& database, std::int64_t newest = kSchemaVersion);

  bool has(const std::string& table, const std::string& field) const;
  bool has_column(const std::string& name) const { return columns_.count(name) != 0; }  // of traces
  bool has_table(const std::string& table) const { return fields_.count(table) != 0; }
  bool is_sealed_as_whole() const { return version_ == kOldestVersion; }

 private:
  std::int64_t version_ = 0;
  std::map<std::string, std::set<std::string>> fields_;  // by table
  std::set<std::string> columns_;
};

template <class Part>
std::vector<std::string> column_names() {
  std::vector<std::string> names;
  Part part;
  visit_fields<Part>(part, [&](const char* name, const auto&) { names.emplace_back(name); });
  return names;
}

template <class Part>
void insert(Database& database, std::int64_t owner, const std::vector<Part>& parts,
            std::int64_t append = 0) {
  int count = 2;
  std::string names = "owner, position";
  std::string places = "?, ?";
  for (const std::string& name : column_names<Part>()) {
    names += ", \"" + name + '"';
    places += ", ?";
  }
  Statement statement = database.prepare("INSERT INTO \"" + std::string(table_name<Part>) + "\" (" +
                                         names + ") VALUES (" + places + ")");
  std::int64_t position = append * kAppendPositions;
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

constexpr std::int64_t kAllAppends = -1;

// The parts of one append, or of all.
template <class Part>
std::vector<Part> select(Database& database, const StoredFields& stored, std::int64_t owner,
                         std::int64_t append = 0) {
  std::vector<Part> parts;
  const std::string table = table_name<Part>;
  if (!stored.has_table(table)) {
    return parts;
  }
  std::string names = "position";
  for (const std::string& name : column_names<Part>()) {
    names += stored.has(table, name) ? ", \"" + name + '"' : "";
  }
  Statement statement =
      database.prepare("SELECT " + names + " FROM \"" + table +
                       "\" WHERE owner = ? AND position >= ? AND position < ? ORDER BY position");
  statement.bind(1, owner);
  const bool all = append == kAllAppends;
  statement.bind(2, all ? 0 : append * kAppendPositions);
  statement.bind(3,
                 all ? std::numeric_limits<std::int64_t>::max() : (append + 1) * kAppendPositions);
  while (statement.step()) {
    Part part;
    int column = 0;
    visit_fields<Part>(part, [&](const char* name, auto& field) {
      if (stored.has(table, name)) {
        statement.get(++column, field);
      }
    });
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace gsbench::record
