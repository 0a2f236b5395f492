// Commands from templates, and values in answers.
#include "text.hpp"

#include <gmock/gmock.h>

namespace gsbench::scpi {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string value(const std::string& answer, const std::string& field) {
  const auto found = value_in(answer, field);
  return found.ok() ? found.value() : "error: " + found.error();
}

TEST(Templates, AreFilled) {
  const Values values = {{"channel", "1"}, {"rate_hz", number_text(32000.0)}};
  EXPECT_EQ(filled("C{channel}:SRATE VALUE,{rate_hz}", values), "C1:SRATE VALUE,32000");
  EXPECT_EQ(filled("{part}{channel", values), "{part}{channel");
  EXPECT_THAT(placeholders("C{channel}:{name},"), ElementsAre("channel", "name"));
}

TEST(Numbers, AreWrittenAsShortAsTheyAre) {
  EXPECT_EQ(number_text(6.512000000000001), "6.512");
  EXPECT_EQ(number_text(0.122070), "0.12207");
  EXPECT_EQ(number_text(128000.0), "128000");
}

TEST(Answers, AreReadWholeByNameAndByNumber) {
  EXPECT_EQ(value(" \"GSBENCH\"\r", ""), "GSBENCH");
  const std::string list = "C1:OUTP ON,LOAD,HZ,PLRT,NOR";
  EXPECT_EQ(value(list, "1"), "ON");
  EXPECT_EQ(value(list, "LOAD"), "HZ");
  EXPECT_EQ(value(list, "plrt"), "NOR");
  EXPECT_EQ(value("ON,LOAD,HZ", "1"), "ON");
  EXPECT_EQ(value("0,\"No error\"", "1"), "0");
}

TEST(Answers, WithoutTheItemAreErrors) {
  EXPECT_THAT(value("C1:OUTP ON,LOAD", "LOAD"), HasSubstr("error: "));
  EXPECT_THAT(value("C1:OUTP ON", "2"), HasSubstr("\"C1:OUTP ON\" has no item 2"));
  EXPECT_THAT(value("", "FRQ"), HasSubstr("has no item FRQ"));
}

TEST(Answers, GiveNumbersWithTheirUnitOnly) {
  EXPECT_EQ(number_in("1000HZ", "HZ").value(), 1000.0);
  EXPECT_EQ(number_in("+6.5120000000000E+00", "").value(), 6.512);
  EXPECT_EQ(number_in("10000Sa/s", "SA/S").value(), 10000.0);
  EXPECT_EQ(number_in("5", "V").value(), 5.0);
  EXPECT_FALSE(number_in("5mV", "V").ok());
  EXPECT_FALSE(number_in("HZ", "HZ").ok());
  EXPECT_FALSE(number_in("", "").ok());
  EXPECT_FALSE(number_in("1.2.3", "").ok());
}

TEST(Texts, AreComparedInAnyCaseWithAlternatives) {
  EXPECT_TRUE(is_one_of("Srate", "SRAT|SRATE"));
  EXPECT_FALSE(is_one_of("SRATES", "SRAT|SRATE"));
}

TEST(Messages, ContainPrintableCharactersOnly) {
  EXPECT_EQ(printable("a\n\x80"), "a\\x0A\\x80");
  EXPECT_LT(printable(std::string(1000, 'a')).size(), 90U);
}

}  // namespace
}  // namespace gsbench::scpi
