#include "generator_rig.hpp"
#include <test_support/mains.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

class AnyGenerator : public testing::TestWithParam<GeneratorCase> {
 protected:
  AnyGenerator() { mains_.duration_s = 0.3; }

  Mains mains_;
  GeneratorRig rig_{GetParam()};
};

INSTANTIATE_TEST_SUITE_P(Of, AnyGenerator, testing::ValuesIn(kGeneratorCases),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_P(AnyGenerator, PlaysAWholeRunAndIsOffAfterwards) {
  const auto source = rig_.make_source();
  EXPECT_EQ(first_error_of_run(*source, mains_), "");
  EXPECT_FALSE(rig_.generator().output_is_on());
}

}  // namespace
}  // namespace gsbench::test
