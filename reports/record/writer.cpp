#include "columns.hpp"
#include "schema.hpp"
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <optional>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

// O_EXCL: fails for an existing file, also if two runs start at the same time.
void create_empty(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) {
    throw StoreError(path + ": cannot be created: " + std::strerror(errno));
  }
  ::close(file);
}

template <class Trace>
void insert_trace(std::vector<Series>& all, const Trace& trace) {
  visit_fields<Trace>(trace, [&](const char* name, const auto& column) {
    if (column.size() != trace.tick.size()) {
      throw std::invalid_argument(std::string(name) + " has " + std::to_string(column.size()) +
                                  " entries, its ticks " + std::to_string(trace.tick.size()));
    }
    all.push_back({name, static_cast<std::int64_t>(column.size()), columns::pack(column)});
  });
}

}  // namespace

struct Writer::Impl {
  explicit Impl(const std::string& path) : database(path, Database::Mode::kWrite) {
    // With WAL and full sync each finished transaction survives a power cut; there are few of them.
    database.execute("PRAGMA journal_mode = WAL");
    database.execute("PRAGMA synchronous = FULL");
    database.transact([&] {
      database.execute("PRAGMA application_id = " + std::to_string(kApplicationId));
      database.execute("PRAGMA user_version = " + std::to_string(kSchemaVersion));
      database.execute(schema_sql());
    });
  }

  ~Impl() {
    try {
      // Back to one plain file, which is readable also in a folder without write permission.
      database.execute("PRAGMA journal_mode = DELETE");
    } catch (const StoreError&) {
      // SQLite then leaves the -wal file and reads it later: nothing is lost.
    }
  }

  void write_head(const RunRecord& run, bool complete) {
    std::vector<Series> series;
    insert_trace(series, run.reference);
    database.transact([&] {
      for (const char* table : {"run", "clock", "comparison", "mark", "series", "seal"}) {
        database.execute("DELETE FROM \"" + std::string(table) +
                         "\" WHERE owner = " + std::to_string(kRunOwner));
      }
      RunRecord head = run;
      head.outlets.clear();
      insert(database, kRunOwner, std::vector<RunRecord>{head});
      insert(database, kRunOwner, run.clocks);
      insert(database, kRunOwner, run.comparisons);
      insert(database, kRunOwner, run.stimulus);
      insert(database, kRunOwner, series);
      insert(database, kRunOwner, std::vector<Seal>{{complete, seal_of_run(head, complete)}});
    });
  }

  void write_outlet(const OutletRecord& outlet) {
    std::vector<Series> series;
    insert_trace(series, outlet.trace);
    insert_trace(series, outlet.estimates);
    std::vector<Setting> settings;
    for (const auto& [name, value] : outlet.settings) {
      settings.push_back({name, value});
    }
    database.transact([&] {
      const std::int64_t owner = outlets + 1;
      insert(database, owner, std::vector<OutletRecord>{outlet});
      insert(database, owner, settings);
      insert(database, owner, outlet.measurements);
      insert(database, owner, outlet.marks);
      insert(database, owner, series);
      insert(database, owner, std::vector<Seal>{{true, seal_of_outlet(outlet)}});
    });
    ++outlets;
  }

  void require(bool in_order, const char* what) const {
    if (!in_order) {
      throw std::logic_error(what);
    }
  }

  Database database;
  std::int64_t outlets = 0;
  bool begun = false;
  bool finished = false;
};

Writer::Writer(const std::string& path) {
  create_empty(path);
  try {
    impl_ = std::make_unique<Impl>(path);
  } catch (...) {
    ::unlink(path.c_str());  // it is new and empty
    throw;
  }
}

Writer::~Writer() = default;

void Writer::begin(const RunRecord& head) {
  impl_->require(!impl_->begun, "begin() was called twice");
  impl_->write_head(head, false);
  impl_->begun = true;
}

void Writer::add_outlet(const OutletRecord& outlet) {
  impl_->require(impl_->begun && !impl_->finished,
                 "add_outlet() must be called between begin() and finish()");
  impl_->write_outlet(outlet);
}

void Writer::finish(const RunRecord& whole) {
  impl_->require(impl_->begun && !impl_->finished, "finish() must be called once, after begin()");
  impl_->write_head(whole, true);
  impl_->finished = true;
}

}  // namespace gsbench::record
