#include "columns.hpp"
#include "new_record.hpp"
#include "read_parts.hpp"
#include "seals.hpp"
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <utility>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

template <class Trace>
void pack_trace(std::vector<Series>& all, const Trace& trace) {
  visit_fields<Trace>(trace, [&](const char* name, const auto& column) {
    if (column.size() != trace.tick.size()) {
      throw std::invalid_argument(std::string(name) + " has " + std::to_string(column.size()) +
                                  " entries, its ticks " + std::to_string(trace.tick.size()));
    }
    if (!column.empty()) {
      all.push_back({name, static_cast<std::int64_t>(column.size()), columns::pack(column)});
    }
  });
}

}  // namespace

struct Writer::Impl {
  struct Appended {
    std::int64_t count = 0;
    std::string seal;  // of the last
  };

  explicit Impl(const std::string& the_path)
      : path(the_path), reserve(the_path), database(the_path, Database::Mode::kWrite) {
    database.execute("PRAGMA journal_mode = WAL");
    // No wait for the disk during a run, which must keep its pace. A finished transaction survives
    // the end of this process; a power cut may take those of the last seconds.
    database.execute("PRAGMA synchronous = NORMAL");
  }

  ~Impl() {
    reserve.free();
    try {
      // Back to one plain file, which is readable also in a folder without write permission.
      database.execute("PRAGMA journal_mode = DELETE");
    } catch (const StoreError&) {
      // SQLite then leaves the -wal file and reads it later: nothing is lost.
    }
  }

  void write_head(const RunRecord& run, bool complete) {
    std::vector<Series> series;
    pack_trace(series, run.reference);
    database.transact([&] {
      for (const char* table : {"run", "clock", "comparison", "mark", "series", "seal"}) {
        remove(table, kRunOwner);
      }
      RunRecord head = run;
      head.outlets.clear();
      insert(database, kRunOwner, std::vector<RunRecord>{head});
      insert(database, kRunOwner, run.clocks);
      insert(database, kRunOwner, run.comparisons);
      insert(database, kRunOwner, run.stimulus);
      insert(database, kRunOwner, series);
      const std::string seals = complete ? seals_of_outlets(database) : "";
      insert(database, kRunOwner,
             std::vector<Seal>{{complete, seal_of_run(head, complete, seals)}});
    });
  }

  void remove(const char* table, std::int64_t owner) {
    database.execute("DELETE FROM \"" + std::string(table) +
                     "\" WHERE owner = " + std::to_string(owner));
  }

  void write_settings(std::size_t number, const OutletRecord& outlet) {
    std::vector<Setting> settings;
    for (const auto& [name, value] : outlet.settings) {
      settings.push_back({name, value});
    }
    insert(database, static_cast<std::int64_t>(number), settings);
  }

  // In place of those that are stored.
  void write_results(std::size_t number, const OutletRecord& outlet) {
    const auto owner = static_cast<std::int64_t>(number);
    for (const char* table : {"outlet", "measurement"}) {
      remove(table, owner);
    }
    database.execute("DELETE FROM seal WHERE position = 0 AND owner = " + std::to_string(owner));
    insert(database, owner, std::vector<OutletRecord>{outlet});
    insert(database, owner, outlet.measurements);
    insert(database, owner, std::vector<Seal>{{true, seal_of_results(outlet)}});
  }

  void write_reports(std::size_t number, const Reports& reports, Appended& appended) {
    if (reports.empty()) {
      return;
    }
    const auto owner = static_cast<std::int64_t>(number);
    std::vector<Series> series;
    pack_trace(series, reports.trace);
    pack_trace(series, reports.estimates);
    appended.seal = seal_of_reports(appended.seal, reports);
    insert(database, owner, reports.marks, appended.count);
    insert(database, owner, reports.sent, appended.count);
    insert(database, owner, series, appended.count);
    insert(database, owner, std::vector<Seal>{{true, appended.seal}}, ++appended.count);
  }

  // In one transaction. What was appended is known only once it is stored.
  void write(const std::function<void(std::vector<Appended>&)>& work) {
    std::vector<Appended> appended = outlets;
    database.transact([&] { work(appended); });
    outlets = std::move(appended);
  }

  void require(bool in_order, const char* what) const {
    if (!in_order) {
      throw std::logic_error(what);
    }
  }

  void require_running() const {
    require(begun && !finished, "outlets are written between begin() and finish()");
  }

  std::string path;
  Reserve reserve;
  Database database;
  std::vector<Appended> outlets;
  bool begun = false;
  bool finished = false;
};

Writer::Writer(const std::string& path) {
  create_record(path);
  try {
    impl_ = std::make_unique<Impl>(path);
  } catch (...) {
    ::unlink(path.c_str());  // it is new and has nothing in it
    throw;
  }
}

Writer::~Writer() = default;

void Writer::begin(const RunRecord& head) {
  impl_->require(!impl_->begun, "begin() was called twice");
  impl_->write_head(head, false);
  impl_->begun = true;
  // Later messages are kept as the run's fault, and its folder gets another name.
  impl_->database.show_as(std::filesystem::path(impl_->path).filename().string());
}

void Writer::add_outlet(const OutletRecord& outlet) {
  impl_->require_running();
  impl_->write([&](std::vector<Impl::Appended>& outlets) {
    outlets.emplace_back();
    impl_->write_settings(outlets.size(), outlet);
    impl_->write_results(outlets.size(), outlet);
    impl_->write_reports(outlets.size(), outlet.reports, outlets.back());
  });
}

void Writer::append(const std::vector<Reports>& reports) {
  impl_->require_running();
  impl_->write([&](std::vector<Impl::Appended>& outlets) {
    for (std::size_t i = 0; i < reports.size(); ++i) {
      impl_->write_reports(i + 1, reports[i], outlets.at(i));
    }
  });
}

void Writer::update_outlet(std::size_t i, const OutletRecord& outlet) {
  impl_->require_running();
  impl_->database.transact([&] { impl_->write_results(i + 1, outlet); });
}

OutletRecord Writer::outlet(std::size_t i) {
  return read_marked(impl_->database, StoredFields(impl_->database), i + 1);
}

void Writer::read_reports(std::size_t i, const TakeReports& take) {
  record::read_reports(impl_->database, StoredFields(impl_->database), i + 1, take);
}

void Writer::finish(const RunRecord& head) {
  impl_->require(impl_->begun && !impl_->finished, "finish() must be called once, after begin()");
  impl_->write_head(head, true);
  impl_->finished = true;
}

void Writer::abandon(const RunRecord& head) noexcept {
  impl_->reserve.free();
  if (!impl_->begun || impl_->finished) {
    return;
  }
  try {
    impl_->write_head(head, false);
  } catch (const std::exception&) {
    try {
      // The -wal file may be at a limit for the size of files.
      impl_->database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
      impl_->write_head(head, false);
    } catch (const std::exception&) {
      // The record then reads as that of a run that was killed.
    }
  }
}

}  // namespace gsbench::record
