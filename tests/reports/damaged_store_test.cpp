// Files that are not records, have another version, or were damaged or forged: always StoreError,
// never a wrong figure or undefined behaviour (the sanitizer presets run these tests, too).
#include "sample_run.hpp"
#include <sqlite3.h>
#include <test_support/refusal.hpp>
#include <test_support/temporary_folder.hpp>

#include <QByteArray>
#include <QCryptographicHash>
#include <filesystem>
#include <random>
#include <string>

#include <gmock/gmock.h>

#include <record/store.hpp>

namespace gsbench::record {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

class DamagedStore : public ::testing::Test {
 protected:
  DamagedStore() : path_(folder_.file("run.sqlite")), run_(sample::loss_500mw(2)) {
    sample::write(path_, run_);
  }

  void change(const std::string& sql) {
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
    char* message = nullptr;
    EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &message), SQLITE_OK)
        << (message != nullptr ? message : "");
    sqlite3_free(message);
    sqlite3_close(database);
  }

  std::string error() const {
    return test::refusal_of<StoreError>([&] { (void)read_run(path_); });
  }

  test::TemporaryFolder folder_;
  std::string path_;
  RunRecord run_;
};

TEST_F(DamagedStore, IsRefusedIfItIsAnotherKindOfFile) {
  folder_.write("run.sqlite", "title = \"a profile, not a record\"\n" + std::string(8192, 'x'));
  EXPECT_EQ(error(), path_ + ": not a gsbench record");
}

TEST_F(DamagedStore, IsRefusedIfItIsAnotherDatabase) {
  std::filesystem::remove(path_);
  change("CREATE TABLE run (owner INTEGER)");
  EXPECT_EQ(error(), path_ + ": not a gsbench record");
}

TEST_F(DamagedStore, OfANewerVersionRequiresANewerGsbench) {
  change("PRAGMA user_version = 8");
  EXPECT_THAT(error(), AllOf(StartsWith(path_), HasSubstr("version 8"), HasSubstr("newer")));
}

// A change of the tables requires a new kSchemaVersion; this digest detects such changes.
TEST_F(DamagedStore, TablesOfVersion7AreUnchanged) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(path_.c_str(), &database), SQLITE_OK);
  QCryptographicHash hash(QCryptographicHash::Sha256);
  const auto add = [](void* sum, int, char** columns, char**) {
    if (columns[0] != nullptr) {
      static_cast<QCryptographicHash*>(sum)->addData(columns[0]);
    }
    return 0;
  };
  ASSERT_EQ(sqlite3_exec(database, "SELECT sql FROM sqlite_schema ORDER BY type, name", add, &hash,
                         nullptr),
            SQLITE_OK);
  sqlite3_close(database);
  EXPECT_EQ(hash.result().toHex().left(16).toStdString(), "303305f8b5217ed5");
}

TEST_F(DamagedStore, IsRefusedWithForeignTables) {
  change("CREATE VIEW more AS SELECT 1");
  EXPECT_THAT(error(), HasSubstr("its tables are not those of a record"));
}

TEST_F(DamagedStore, IsRefusedIfAnyFigureIsChanged) {
  const std::string original = folder_.read("run.sqlite");
  for (const char* sql : {
           "UPDATE measurement SET value = value + 1 WHERE owner = 2 AND name = 'event.delay'",
           "UPDATE measurement SET verdict = 0, judged = 0 WHERE owner = 1 AND position = 0",
           "UPDATE run SET verdict = 2",
           "UPDATE run SET started_utc = ''",
           "UPDATE seal SET complete = 0 WHERE owner = 0",
           "UPDATE mark SET tick = tick + 1 WHERE owner = 1 AND position = 0",
           "UPDATE comparison SET ours = 1 WHERE position = 0",
           "DELETE FROM measurement WHERE owner = 1 AND position = 0",
           "DELETE FROM setting WHERE owner = 2",
           "DELETE FROM series WHERE owner = 1 AND position = 0",
           "DELETE FROM sent WHERE owner = 1",
           "UPDATE sent SET message = x'00' WHERE owner = 1",
           "DELETE FROM series WHERE owner = 1",
           "DELETE FROM seal WHERE owner = 1 AND position > 0",
           "DELETE FROM seal WHERE owner = 1 AND position = 0",
           "UPDATE outlet SET clock_samples_per_tick = 2 WHERE owner = 1",
           "UPDATE outlet SET owner = 7 WHERE owner = 2",
           "UPDATE series SET entries = 9000000000000000000 WHERE owner = 1 AND position = 1",
           "UPDATE series SET entries = -1 WHERE owner = 1 AND position = 1",
           "UPDATE series SET entries = entries - 1 WHERE owner = 1 AND position = 1",
           "UPDATE series SET data = x'' WHERE owner = 1 AND position = 1",
           "UPDATE series SET data = randomblob(500) WHERE owner = 1 AND position = 1",
           "UPDATE measurement SET verdict = 77 WHERE owner = 1 AND position = 1",
           "UPDATE measurement SET judged = 5 WHERE owner = 1 AND position = 1",
       }) {
    folder_.write("run.sqlite", original);
    change(sql);
    EXPECT_THAT(error(), HasSubstr("the record is damaged")) << sql;
  }
}

TEST_F(DamagedStore, IsRefusedIfTruncatedAnywhere) {
  const std::string original = folder_.read("run.sqlite");
  for (std::size_t size = 1; size < original.size(); size += 1021) {
    folder_.write("run.sqlite", original.substr(0, size));
    EXPECT_NE(error(), "") << size << " bytes of " << original.size();
  }
}

// Bits in the free space of a page or in SQLite's counters may flip without any effect. The file
// must be refused or read back unchanged.
TEST_F(DamagedStore, NeverReadsAsAnotherRecordAfterBitFlips) {
  const std::string original = folder_.read("run.sqlite");
  const std::string digest = content_digest(run_);
  std::mt19937 random(20260301);
  int refused = 0;
  constexpr int kTrials = 500;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::string damaged = original;
    const std::size_t flips = 1 + random() % 4;
    for (std::size_t i = 0; i < flips; ++i) {
      damaged[random() % damaged.size()] ^= static_cast<char>(1U << (random() % 8U));
    }
    folder_.write("run.sqlite", damaged);
    try {
      ASSERT_EQ(content_digest(read_run(path_)), digest) << "trial " << trial;
    } catch (const StoreError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, kTrials / 4);  // more than the headers alone: the content is checked
}

}  // namespace
}  // namespace gsbench::record
