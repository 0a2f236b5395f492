// Source with a driver that fails or returns an impossible tick.
#include <test_support/mains.hpp>

#include <string>

#include <gmock/gmock.h>

#include <source/source.hpp>

namespace gsbench::test {
namespace {

using drivers::Done;
using drivers::Error;
using drivers::Status;

class FailingSource final : public source::Source {
 public:
  explicit FailingSource(std::string fails) : fails_(std::move(fails)) {}
  source::Limits limits() const override {
    source::Limits limits;
    limits.name = "failing source";
    limits.full_scale_pu = 2.0;
    limits.sample_rates_hz = {8000};
    limits.nominal_hz = {50};
    return limits;
  }

  std::int64_t off_by = 0;
  bool is_off = false;

 protected:
  drivers::Result<source::Played> deviation(const source::Stimulus&) const override {
    if (fails_ == "check") {
      return Error{"check fails"};
    }
    return source::Played{0.1, 0.2, 0.3};
  }
  Status upload(const source::Progress&) override { return answer("prepare"); }
  Status power_up() override { return answer("energise"); }
  Status begin() override { return answer("start"); }
  drivers::Result<std::int64_t> play_until(std::int64_t until_tick) override {
    if (fails_ == "advance") {
      return Error{"advance fails"};
    }
    return until_tick + off_by;
  }
  Status end() override { return answer("stop"); }
  Status switch_off() noexcept override {
    is_off = true;
    return answer("make_safe");
  }

 private:
  Status answer(const char* call) const {
    return fails_ == call ? Status(Error{fails_ + " fails"}) : Status(Done{});
  }

  std::string fails_;
};

// Makes all calls in order and returns the first error.
std::string first_error(source::Source& source, const source::Stimulus& stimulus) {
  const auto prepared = source.prepare(stimulus);
  if (!prepared.ok()) {
    return prepared.error();
  }
  for (const auto call : {&source::Source::energise, &source::Source::start}) {
    const Status status = (source.*call)();
    if (!status.ok()) {
      return status.error();
    }
  }
  const auto played = source.advance(800);
  if (!played.ok()) {
    return played.error();
  }
  const Status stopped = source.stop();
  return stopped.ok() ? "" : stopped.error();
}

class DriverFault : public testing::TestWithParam<const char*> {};

INSTANTIATE_TEST_SUITE_P(EachCall, DriverFault,
                         testing::Values("prepare", "energise", "start", "advance", "stop"));

TEST_P(DriverFault, IsReportedAndAllowsOnlyMakeSafe) {
  const Mains mains;
  FailingSource source(GetParam());
  EXPECT_EQ(first_error(source, mains), std::string(GetParam()) + " fails");
  EXPECT_THAT(source.prepare(mains).error(), testing::HasSubstr("cannot prepare while failed"));
  EXPECT_FALSE(source.advance(1600).ok());
  EXPECT_FALSE(source.is_off);
  EXPECT_TRUE(source.make_safe().ok());
  EXPECT_TRUE(source.is_off);
  EXPECT_EQ(first_error(source, mains), std::string(GetParam()) + " fails");
}

TEST(DriverFault, InCheckPreventsPreparation) {
  const Mains mains;
  FailingSource source("check");
  EXPECT_EQ(first_error(source, mains), "check fails");
  EXPECT_FALSE(source.energise().ok());
}

TEST(DriverFault, InMakeSafeIsReportedAndAllowsNothingElse) {
  const Mains mains;
  FailingSource source("make_safe");
  EXPECT_EQ(first_error(source, mains), "");
  EXPECT_EQ(source.make_safe().error(), "make_safe fails");
  EXPECT_FALSE(source.prepare(mains).ok());
}

TEST(Driver, PrepareReturnsTheDeviationOfCheck) {
  const Mains mains;
  FailingSource source("");
  const auto promised = source.prepare(mains);
  ASSERT_TRUE(promised.ok());
  EXPECT_EQ(promised.value().frequency_hz, 0.1);
  EXPECT_EQ(promised.value().voltage_pu, 0.2);
  EXPECT_EQ(promised.value().time_s, 0.3);
}

TEST(Driver, IsFailedIfItReportsATickOutOfRange) {
  const Mains mains;
  for (const std::int64_t off_by : {std::int64_t{-1}, mains.total_ticks() - 800 + 1}) {
    FailingSource source("");
    source.off_by = off_by;
    EXPECT_THAT(first_error(source, mains),
                testing::HasSubstr("but is at tick " + std::to_string(800 + off_by)));
    EXPECT_FALSE(source.stop().ok());
  }
}

}  // namespace
}  // namespace gsbench::test
