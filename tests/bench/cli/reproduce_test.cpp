// The paper's tables and fleets as users and scripts meet them.
#include "gsbench_process.hpp"
#include <test_support/temporary_folder.hpp>

#include <map>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace {

using gsbench::test::Outcome;
using gsbench::test::run_gsbench;
using gsbench::test::TemporaryFolder;
using gsbench::test::text_of;
using nlohmann::json;

json reproduced(const std::string& only, const std::string& threads = "2") {
  const Outcome outcome =
      run_gsbench({"reproduce", "--only", only, "--n", "20000", "--threads", threads, "--json"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  return json::parse(outcome.out);
}

// The figure of a table's row and column, in the first table that has both.
double figure(const json& section, const std::string& row_name, const std::string& column) {
  for (const json& table : section["tables"]) {
    for (std::size_t i = 0; i < table["columns"].size(); ++i) {
      for (const json& row : table["rows"]) {
        if (table["columns"][i] == column && row["name"] == row_name) {
          return row["figures"][i];
        }
      }
    }
  }
  ADD_FAILURE() << "no " << row_name << " × " << column;
  return 0.0;
}

TEST(Reproduce, Table4IsBetterThanPrinted) {
  const json section = reproduced("table4")["sections"][0];
  EXPECT_EQ(section["id"], "table4");
  EXPECT_EQ(figure(section, "paper", "within 4 %, %"), 92.38);
  EXPECT_GE(figure(section, "gsbench", "within 4 %, %"), 99.9);
  EXPECT_EQ(figure(section, "gsbench", "beyond 10 %, %"), 0.0);
  EXPECT_GE(figure(section, "gsbench, Gaussian σ = 0.01 Hz, loss on a report", "within 4 %, %"),
            99.0);
}

TEST(Reproduce, Table5IsBetterThanPrinted) {
  const json section = reproduced("table5")["sections"][0];
  EXPECT_GE(figure(section, "gsbench", "within 4 %, %"), 77.0);
}

TEST(Reproduce, AMillionOutletsShedWhatIsWanted) {
  const json section = reproduced("fig21")["sections"][0];
  EXPECT_NEAR(figure(section, "wanted", "MW"), 148.08, 0.01);
  EXPECT_NEAR(figure(section, "gsbench, P^A with half of its own group", "off what is wanted, %"),
              0.0, 0.1);
}

TEST(Reproduce, EverySectionIsTheSameOnAnyNumberOfThreads) {
  const json one = reproduced("table2,table3,table4,table5,fig16,fig22", "1");
  EXPECT_EQ(one["sections"].size(), 6U);
  for (const char* threads : {"2", "3"}) {
    EXPECT_EQ(reproduced("table2,table3,table4,table5,fig16,fig22", threads), one) << threads;
  }
}

TEST(Reproduce, WritesAReportThatStandsAlone) {
  const TemporaryFolder folder;
  const std::string report = folder.file("paper.html");
  const Outcome outcome = run_gsbench({"reproduce", "--only", "fig13,table1,fig14", "-o", report});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("351.921"), std::string::npos) << outcome.out;
  const std::string text = text_of(report);
  EXPECT_NE(text.find("id=\"table1\""), std::string::npos);
  EXPECT_EQ(text.find("<script src"), std::string::npos);
  EXPECT_EQ(text.find("<link rel=\"stylesheet\""), std::string::npos);
}

TEST(Reproduce, RefusesWhatThereIsNone) {
  const Outcome outcome = run_gsbench({"reproduce", "--only", "table9"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("\"table9\" cannot be reproduced; there are fig13, table1"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(run_gsbench({"reproduce", "--n", "0"}).exit_code, 2);
  EXPECT_EQ(run_gsbench({"reproduce", "--only", "fig13", "-o", "/nowhere/x.html"}).exit_code, 2);
}

TEST(Fleet, SetsGridSenseBesideOtherControls) {
  const Outcome outcome = run_gsbench({"fleet", "--per-group", "20", "--least", "500", "--most",
                                       "90000", "--delay-aware", "--json"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json section = json::parse(outcome.out)["sections"][0];
  EXPECT_NEAR(figure(section, "no control", "nadir, Hz"), 49.290, 0.001);
  EXPECT_NEAR(figure(section, "Grid Sense, by each outlet's estimate", "shed, MW"), 148.1, 1.5);
  EXPECT_NEAR(figure(section, "central control", "first action, s"), 1.9, 1e-9);
  const json& rows = section["tables"][0]["rows"];
  ASSERT_EQ(rows.size(), 6U);
  EXPECT_GE(rows[5]["figures"][6].get<double>(), 49.5);  // the threshold that knows of the delay
}

TEST(Fleet, SweepsAsHeatMapsOnAnyGrid) {
  const TemporaryFolder folder;
  const std::string report = folder.file("sweep.html");
  const Outcome outcome =
      run_gsbench({"fleet", "island-60hz", "--loss", "12", "--groups", "50", "--per-group", "20",
                   "--most", "40000", "--duration", "5", "--sweep", "-o", report});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(text_of(report).find("background: hsl("), std::string::npos);
}

TEST(Fleet, RefusesWhatMakesNoSense) {
  for (const auto& [option, value] :
       std::map<std::string, std::string>{{"--loss", "0"}, {"--groups", "0"}, {"--noise", "-1"}}) {
    const Outcome outcome = run_gsbench({"fleet", option, value});
    EXPECT_EQ(outcome.exit_code, 2) << option;
    EXPECT_FALSE(outcome.err.empty());
  }
}

}  // namespace
