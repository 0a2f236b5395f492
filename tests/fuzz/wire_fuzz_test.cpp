// Short form of the wire fuzzers: all seeds and some thousand deterministic mutations of them.
#include "mutator.hpp"
#include "wire_input.hpp"

#include <ostream>

#include <gtest/gtest.h>

#include <wire/codec.hpp>

namespace gsbench::fuzz {

// Found by GoogleTest to name the cases.
void PrintTo(const WireFuzzer& fuzzer, std::ostream* out);
void PrintTo(const WireFuzzer& fuzzer, std::ostream* out) {
  *out << fuzzer.name;
}

namespace {

constexpr int kMutations = 20000;

// Heads of CBOR items, special floats, zeros and frame delimiters.
const std::vector<std::string> kPieces = {std::string(1, '\0'),
                                          std::string(4, '\0'),
                                          "\x01",
                                          "\xff",
                                          "\x18\x21",
                                          "\x1a\xff\xff\xff\xff",
                                          "\x1b\xff\xff\xff\xff\xff\xff\xff\xff",
                                          "\x3b\x80\x01\x01\x01\x01\x01\x01\x01",
                                          "\x9b\xff\xff\xff\xff\xff\xff\xff\xff",
                                          "\x9f",
                                          "\x81\x81\x81\x81\x81\x81\x81\x81",
                                          "\xa1\x01",
                                          "\xc0",
                                          "\xf4",
                                          "\xf6",
                                          "\xf9\x7e\x01",
                                          "\xfa\x7f\xc1\x01\x01",
                                          "\xfa\x7f\x7f\xff\xff",
                                          "\xfb\x7f\xf8\x01\x01\x01\x01\x01\x01",
                                          "\x7a\xff\xff\xff\xff"};

std::string wrong_with(const WireFuzzer& fuzzer, const std::string& input) {
  return fuzzer.wrong_with(reinterpret_cast<const std::uint8_t*>(input.data()), input.size());
}

class WireFuzz : public testing::TestWithParam<WireFuzzer> {};

TEST_P(WireFuzz, SeedsPassTheCheck) {
  const std::vector<std::string> seeds = GetParam().seeds();
  ASSERT_GE(seeds.size(), 3U);
  for (const std::string& seed : seeds) {
    EXPECT_EQ(wrong_with(GetParam(), seed), "");
  }
  EXPECT_EQ(wrong_with(GetParam(), ""), "");
}

TEST_P(WireFuzz, MutationsPassTheCheck) {
  Mutator mutator(GetParam().seeds(), kPieces, 1);
  for (int i = 0; i < kMutations; ++i) {
    const std::string input = mutator.next();
    ASSERT_EQ(wrong_with(GetParam(), input), "")
        << "mutation " << i << ": " << testing::PrintToString(input);
  }
}

INSTANTIATE_TEST_SUITE_P(All, WireFuzz, testing::ValuesIn(wire_fuzzers()),
                         [](const auto& fuzzer) { return std::string(fuzzer.param.name); });

// Mutations that all fail at the first byte would test nothing.
TEST(WireFuzzMutations, OfSettingsArePartlyReadAndPartlyRefused) {
  Mutator mutator(wire_fuzzers()[2].seeds(), kPieces, 1);
  int read = 0;
  int valid = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string input = mutator.next();
    gs::outlet::Settings settings;
    if (gs::wire::decode(reinterpret_cast<const std::uint8_t*>(input.data()), input.size(),
                         settings) != gs::wire::Decoded::kOk) {
      continue;
    }
    ++read;
    valid += gs::outlet::validate(settings, 50.0F) == gs::outlet::SettingsError::kNone ? 1 : 0;
  }
  EXPECT_GT(read, kMutations / 50);
  EXPECT_LT(read, kMutations / 2);
  EXPECT_GT(valid, 20);
  EXPECT_LT(valid, read);
}

}  // namespace
}  // namespace gsbench::fuzz
