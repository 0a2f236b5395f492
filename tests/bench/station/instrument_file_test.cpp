// Texts of an instrument file that the driver could not use are refused with line and column.
#include <test_support/refusal.hpp>
#include <test_support/temporary_folder.hpp>

#include <algorithm>

#include <gmock/gmock.h>

#include <profile/files.hpp>
#include <station/instrument_file.hpp>

namespace gsbench::station::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class InstrumentFile : public testing::Test {
 protected:
  // The shipped file with one text replaced: the refusal, and where it must point to.
  void expect_refused(const std::string& key, const std::string& value,
                      const std::string& message) const {
    std::string text = shipped_;
    const std::size_t line_start = text.find("\n" + key + " = ") + 1;
    ASSERT_NE(line_start, 0U) << key;
    const std::size_t line_end = text.find('\n', line_start);
    text.replace(line_start, line_end - line_start, key + " = " + value);
    const auto line =
        std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(line_start), '\n') + 1;
    const std::string path = folder_.write("own.toml", text);
    EXPECT_THAT(
        gsbench::test::refusal_of<keys::ConfigurationError>([&] { (void)load_instrument(path); }),
        AllOf(StartsWith(path + ":" + std::to_string(line) + ":" + std::to_string(key.size() + 4) +
                         ": " + key + ": "),
              HasSubstr(message)))
        << value;
  }

  const gsbench::test::TemporaryFolder folder_;
  const std::string shipped_ = [] {
    for (const profile::NamedFile& file : all_instruments()) {
      if (file.name == "siglent-sdg2000x") {
        return profile::read_file(file.path);
      }
    }
    return std::string();
  }();
};

TEST_F(InstrumentFile, RefusesAnItemThatNoAnswerHas) {
  for (const char* field : {"99999999999999999999999", "1000", "0", "000"}) {
    expect_refused("output_field", '"' + std::string(field) + '"', "counted from 1 to 999");
  }
}

TEST_F(InstrumentFile, RefusesAPlaceholderThatIsUnknownOrNotClosed) {
  expect_refused("output_off", "\"C{chanel}:OUTP OFF\"",
                 "unknown placeholder {chanel} in \"C{chanel}:OUTP OFF\"; known: {channel}, ");
  expect_refused("output_off", "\"C{channel}:OUTP {amplitude_vpp\"", "without its closing brace");
  expect_refused("output_off", "\"C{channel:OUTP {channel}\"", "unknown placeholder");
}

TEST_F(InstrumentFile, RefusesACommandOfMoreThanOneLine) {
  expect_refused("output_off", "\"OUTP OFF\\nOUTP ON\"", "a line end");
  expect_refused("output_off", "\"OUTP OFF\\r\"", "a line end");
}

}  // namespace
}  // namespace gsbench::station::test
