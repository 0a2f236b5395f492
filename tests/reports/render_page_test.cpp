// Pages of figures: the digits of tables, and their layout in the lines of a terminal.
#include "format.hpp"
#include "json_text.hpp"
#include "text_table.hpp"

#include <limits>

#include <gmock/gmock.h>

#include <render/page.hpp>

namespace gsbench::render {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

record::Page page_of(const record::FigureTable& table) {
  record::Page page;
  page.sections.resize(1);
  page.sections[0].tables = {table};
  return page;
}

// 49.487474 rounded twice would become 49.4875 and then 49.488.
TEST(PageOfFigures, RoundsOnceToTheDecimalsOfItsColumn) {
  const record::Page page = page_of({"",
                                     "",
                                     {{"shed, MW", 2}, {"nadir, Hz", 3}},
                                     {{"", {148.170249, 49.487474}}, {"", {158.3, 49.5}}}});
  for (const std::string& text : {terminal(page), html(page)}) {
    EXPECT_THAT(text, AllOf(HasSubstr("148.17"), HasSubstr("49.487"), HasSubstr("158.30"),
                            HasSubstr("49.500")));
    EXPECT_THAT(text, Not(AnyOf(HasSubstr("148.170"), HasSubstr("49.4875"))));
  }
  EXPECT_THAT(json(page), AllOf(HasSubstr("148.170249"), HasSubstr("49.487474")));
}

TEST(PageOfFigures, ARowMayHaveItsOwnDecimals) {
  const record::Page page =
      page_of({"", "", {{"gsbench", 1}}, {{"threshold", {351.921}}, {"nadir", {49.50047}, 3}}});
  EXPECT_THAT(terminal(page), AllOf(HasSubstr(" 351.9\n"), HasSubstr(" 49.500\n")));
}

TEST(PageOfFigures, PrintsNoneOutsideTheRangeOfItsColumn) {
  const record::Page page =
      page_of({"",
               "",
               {{"last group", 0, 1.0}, {"first group", 0, 1.0, 1000.0}},
               {{"a", {0.0, 1000.0}}, {"b", {1.0, 1001.0}}, {"c", {record::kNoFigure, 1.0}}}});
  EXPECT_THAT(terminal(page), AllOf(HasSubstr("a        none         1000\n"),
                                    HasSubstr("b           1         none\n"),
                                    HasSubstr("c           –            1\n")));
  EXPECT_THAT(html(page), HasSubstr(">none<"));
  EXPECT_THAT(json(page), AllOf(HasSubstr("1001"), Not(HasSubstr("none"))));
}

TEST(PageOfFigures, JsonHasATableAsAListIfItHasAName) {
  record::FigureTable table = {"", "", {{"shed, MW", 2}, {"outlets off"}}, {{"none", {0.5, 7.0}}}};
  EXPECT_EQ(Json::parse(json(page_of(table))).count("closed_loop"), 0U);
  table.list = "closed_loop";
  table.row_key = "strategy";
  table.columns[0].key = "shed_mw";
  table.columns[1].key = "outlets_off";
  table.rows.push_back({"central", {record::kNoFigure, record::kNoFigure}});
  EXPECT_EQ(Json::parse(json(page_of(table)))["closed_loop"].dump(),
            R"([{"strategy":"none","shed_mw":0.5,"outlets_off":7},)"
            R"({"strategy":"central","shed_mw":null,"outlets_off":null}])");
}

TEST(PageOfFigures, RowsMayHaveAVerdictAndListsOfTheirOwn) {
  record::FigureTable own = {"", "", {{"shed, MW", 2}}, {{"none", {0.5}}}};
  own.list = "strategies";
  own.row_key = "strategy";
  own.columns[0].key = "shed_mw";
  record::FigureTable table = {"", "set/", {{"nadir, Hz", 1}}};
  table.list = "cases";
  table.row_key = "case";
  table.row_prefix = "set/";
  table.rows = {{"a", {49.5}, {}, record::Judgement{true, {}}, {own}},
                {"b", {48.5}, {}, record::Judgement{false, {"too low"}}},
                {"c", {49.0}, {}, record::Judgement{std::nullopt, {"not known"}}}};
  const record::Page page = page_of(table);
  EXPECT_EQ(Json::parse(json(page))["cases"].dump(),
            R"([{"case":"set/a","verdict":"PASS","reasons":[],)"
            R"("strategies":[{"strategy":"none","shed_mw":0.5}]},)"
            R"({"case":"set/b","verdict":"FAIL","reasons":["too low"]},)"
            R"({"case":"set/c","verdict":null,"reasons":["not known"]}])");
  EXPECT_THAT(terminal(page), HasSubstr("  set/  nadir, Hz\n"
                                        "  a          49.5  PASS\n"
                                        "  b          48.5  FAIL\n"
                                        "  c          49.0     –\n"));
  EXPECT_THAT(html(page), HasSubstr("<td class=\"missed\" style=\"\">FAIL</td>"));
}

TEST(PageOfFigures, JsonHasTheVerdictOfAJudgedPage) {
  record::Page page;
  EXPECT_EQ(Json::parse(json(page)).count("verdict"), 0U);
  page.judgement = record::Judgement{false, {"too low"}};
  EXPECT_EQ(Json::parse(json(page))["verdict"], "FAIL");
  EXPECT_EQ(Json::parse(json(page))["reasons"], Json::array({"too low"}));
  page.judgement->passed = std::nullopt;
  EXPECT_TRUE(Json::parse(json(page))["verdict"].is_null());
}

TEST(Fixed, HasThatManyDecimalsAndNoNegativeZero) {
  EXPECT_EQ(fixed(148.0, 2), "148.00");
  EXPECT_EQ(fixed(-0.0004, 2), "0.00");
  EXPECT_EQ(fixed(0.9, 0), "1");
  EXPECT_EQ(fixed(std::numeric_limits<double>::quiet_NaN(), 2), "–");
  EXPECT_EQ(fixed(-std::numeric_limits<double>::infinity(), 2), "-∞");
}

TEST(Wrapped, BreaksAtSpacesWithAHangingIndent) {
  EXPECT_EQ(wrapped("one two three", 7, 2), "one two\n  three");
  EXPECT_EQ(wrapped("one two three", 100, 2), "one two three");
  EXPECT_EQ(wrapped("", 10, 2), "");
}

TEST(Wrapped, CountsCharactersNotBytes) {
  EXPECT_EQ(wrapped("±± σσ ΔΔ", 5), "±± σσ\nΔΔ");
}

TEST(Wrapped, KeepsLongWordsLineEndsAndAFirstIndent) {
  EXPECT_EQ(wrapped("a longest-word b", 5), "a\nlongest-word\nb");
  EXPECT_EQ(wrapped("a\nb", 5, 1), "a\n b");
  EXPECT_EQ(wrapped("  a b", 3), "  a\nb");
}

TEST(TableLines, AlignsNamesLeftAndFiguresRight) {
  EXPECT_THAT(table_lines({{"", "shed, MW", "end"}, {"none", "0", "49.6"}, {"all", "148"}}, 100),
              ElementsAre("      shed, MW   end", "none         0  49.6", "all        148"));
}

TEST(TableLines, BreaksHeadingsThenRowNamesUntilTheTableFits) {
  const std::vector<std::vector<std::string>> rows = {
      {"", "first action, s", "last action, s"},
      {"a name of a row that takes more columns than are left", "0.900", "0.916"}};
  EXPECT_THAT(
      table_lines(rows, 77),
      ElementsAre("                                                           first       last",
                  "                                                       action, s  action, s",
                  "a name of a row that takes more columns than are left      0.900      0.916"));
  EXPECT_THAT(table_lines(rows, 60),
              ElementsAre("                                     first       last",
                          "                                 action, s  action, s",
                          "a name of a row that takes more",
                          "  columns than are left              0.900      0.916"));
}

TEST(TableLines, PrintsTheColumnsInPartsIfTheyDoNotFit) {
  std::vector<std::vector<std::string>> rows = {{"loss"}, {"400 MW"}};
  for (int i = 0; i < 30; ++i) {
    rows[0].push_back(std::to_string(i));
    rows[1].push_back("49.487");
  }
  const std::vector<std::string> lines = table_lines(rows, 50);
  EXPECT_THAT(lines, SizeIs(2 * 6));  // five columns each
  for (const std::string& line : lines) {
    EXPECT_LE(columns_of(line), 50U);
  }
  EXPECT_EQ(lines[2], "loss         5       6       7       8       9");
}

}  // namespace
}  // namespace gsbench::render
