// Short form of the fuzzer of emulated generators: its seeds and some thousand deterministic
// mutations of them.
#include "generator_input.hpp"
#include "mutator.hpp"

#include <gtest/gtest.h>

namespace gsbench::fuzz {
namespace {

constexpr int kGeneratorMutations = 20000;

const std::vector<std::string> kScpiPieces = {
    "INF", "MIN",  "MAX",   "1e308",    "-1e-308", "0",    "-1",    "1e400", "nan", "0x10", "#15ab",
    "#9",  "#0",   "#3999", "\"",       "'",       ";",    ":",     "?",     ",",   "\n",   "\r",
    " ",   "*TRG", "*RST",  "LENGTH,5", "HZ",      "kVpp", "\x0a#", "[",     "]",   "\xff", "DBM"};

std::string wrong_with_text(const std::string& input) {
  return wrong_with_generator(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

TEST(GeneratorFuzz, SeedsPassTheCheck) {
  for (const std::string& seed : generator_seeds()) {
    EXPECT_EQ(wrong_with_text(seed), "");
  }
  EXPECT_EQ(wrong_with_text(""), "");
}

TEST(GeneratorFuzz, MutationsPassTheCheck) {
  Mutator mutator(generator_seeds(), kScpiPieces, 1);
  for (int i = 0; i < kGeneratorMutations; ++i) {
    const std::string input = mutator.next();
    ASSERT_EQ(wrong_with_text(input), "")
        << "mutation " << i << ": " << testing::PrintToString(input);
  }
}

}  // namespace
}  // namespace gsbench::fuzz
