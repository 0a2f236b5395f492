// Properties of all report formats.
#include "sample_run.hpp"

#include <set>

#include <gmock/gmock.h>

#include <render/render.hpp>

namespace gsbench::render {
namespace {

using ::testing::HasSubstr;

TEST(Formats, HaveUniqueNamesAndFiles) {
  std::set<std::string> taken;
  for (const Format& format : kFormats) {
    EXPECT_EQ(find_format(format.name), &format);
    EXPECT_TRUE(taken.insert(format.name).second) << format.name;
    EXPECT_TRUE(!format.is_kept() || taken.insert(format.file).second) << format.file;
    EXPECT_NE(std::string(format.description), "") << format.name;
  }
  EXPECT_EQ(find_format("htm"), nullptr);
}

TEST(Formats, GiveTheSameTextForTheSameRecord) {
  for (const Format& format : kFormats) {
    EXPECT_TRUE(format.render(sample::loss_500mw()) == format.render(sample::loss_500mw()))
        << format.name;
  }
}

// CSV has traces only, and no faults.
TEST(Formats, ShowTheFaultsOfTheBenchAndOfAnOutlet) {
  record::RunRecord lost_outlet;
  lost_outlet.verdict = record::Verdict::kError;
  lost_outlet.outlets.resize(2);
  lost_outlet.outlets[1].fault = "fell silent";
  lost_outlet.outlets[1].verdict = record::Verdict::kError;
  record::RunRecord lost_source = lost_outlet;
  lost_source.fault = "the source stopped";
  for (const Format& format : kFormats) {
    if (format.render == find_format("csv")->render) {
      continue;
    }
    EXPECT_THAT(format.render(lost_outlet), HasSubstr("fell silent")) << format.name;
    EXPECT_THAT(format.render(lost_source), HasSubstr("fell silent")) << format.name;
    EXPECT_THAT(format.render(lost_source), HasSubstr("the source stopped")) << format.name;
  }
}

}  // namespace
}  // namespace gsbench::render
