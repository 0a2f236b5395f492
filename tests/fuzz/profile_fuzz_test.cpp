// Short form of the profile fuzzer: all shipped profiles, all profiles of the tests, and some
// thousand deterministic mutations of them.
#include "mutator.hpp"
#include "profile_input.hpp"
#include <profile_test/texts.hpp>

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include <gtest/gtest.h>

namespace gsbench::fuzz {
namespace {

constexpr int kMutations = 20000;

std::vector<std::string> corpus() {
  std::vector<std::string> texts = {profile::test::kMinimal, profile::test::kLossesInPlace,
                                    profile::test::kPoints, profile::test::kRecording};
  for (const profile::ProfileSummary& summary : profile::list_profiles()) {
    std::ifstream file(profile::profiles_folder() + "/" + summary.name + ".toml");
    texts.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return texts;
}

std::vector<std::string> tokens() {
  std::istringstream values(R"(
    nan inf -inf 0 -0.0 -1 1 1e-300 1e300 9223372036854775807 -9223372036854775808
    99999999999999999999 0x7f true "" "x" ''' [] [[]] [[1,2]] [[0,50],[0,50]] {} {x=1} 1979-05-27
    07:32:00 1000 32000 50.0 "ieee24" "island-60hz" "en50160" "off" "ms" "event.delay" # .
    [[[[[[[[[[[[[[[[ )");
  std::vector<std::string> all{std::istream_iterator<std::string>(values), {}};
  all.insert(all.end(), {"\n[grid]\n", "\n[[outlet]]\n", "\n[[expect]]\n", "\n[signal.trace]\n",
                         "\n[[grid.loss]]\nat_s = 1\npower_mw = 1\n", "\nseed = 1\n", "= ", "\r\n",
                         "\t", std::string("\0", 1), "\xff", "\xc3\xa4"});
  return all;
}

TEST(ProfileFuzz, CorpusIsAcceptedOrRefusedWithLineAndColumn) {
  const auto texts = corpus();
  ASSERT_GT(texts.size(), 4u) << "the shipped profiles are missing";
  for (const std::string& text : texts) {
    EXPECT_EQ(wrong_with(text), "") << text;
  }
}

TEST(ProfileFuzz, MutationsAreAcceptedOrRefusedWithLineAndColumn) {
  Mutator mutator(corpus(), tokens(), 1);
  int accepted = 0;
  for (int i = 0; i < kMutations; ++i) {
    const std::string text = mutator.next();
    ASSERT_EQ(wrong_with(text), "") << "mutation " << i << ":\n" << text;
    try {
      (void)parse_as_gsbench(text);
      ++accepted;
    } catch (const profile::ConfigurationError&) {
    }
  }
  // Mutations that all fail at the first byte would test nothing. About one in fifteen is accepted,
  // depending on the shipped profiles.
  EXPECT_GT(accepted, kMutations / 50);
  EXPECT_LT(accepted, kMutations / 2);
}

// The check itself can fail: it detects each fault of a loader.
TEST(ProfileFuzz, CheckDetectsAnExceptionOfAnotherType) {
  EXPECT_EQ(
      wrong_with("",
                 [](const std::string&) -> profile::Plan { throw std::out_of_range("map::at"); }),
      "exception of another type: map::at");
}

TEST(ProfileFuzz, CheckDetectsARefusalWithoutLineAndColumn) {
  EXPECT_EQ(wrong_with("",
                       [](const std::string&) -> profile::Plan {
                         throw profile::ConfigurationError("fuzz.toml: bad");
                       }),
            "refused without line and column: fuzz.toml: bad");
}

TEST(ProfileFuzz, CheckDetectsInvalidPlans) {
  const auto wrong_with_changed = [](void (*change)(profile::Plan&)) {
    return wrong_with(profile::test::kMinimal, [change](const std::string& text) {
      profile::Plan plan = parse_as_gsbench(text);
      change(plan);
      return plan;
    });
  };
  EXPECT_EQ(wrong_with_changed([](profile::Plan&) {}), "");
  EXPECT_EQ(wrong_with_changed([](profile::Plan& plan) { plan.stimulus.duration_s = 0.0; }),
            "the duration is not positive");
  EXPECT_EQ(wrong_with_changed([](profile::Plan& plan) { plan.expectations.clear(); }),
            "no limits");
  EXPECT_EQ(wrong_with_changed([](profile::Plan& plan) { plan.outlets.clear(); }), "no outlets");
  EXPECT_EQ(
      wrong_with_changed([](profile::Plan& plan) { plan.outlets.push_back(plan.outlets[0]); }),
      "two outlets with the same id");
  EXPECT_EQ(wrong_with_changed([](profile::Plan& plan) {
              plan.commands.push_back({0.0, {"unknown"}, true});
            }),
            "a command to an unknown outlet");
  EXPECT_EQ(wrong_with_changed([](profile::Plan& plan) {
              plan.settings.push_back({0.0, {{"unknown", {}}}, ""});
            }),
            "settings for an unknown outlet");
}

}  // namespace
}  // namespace gsbench::fuzz
