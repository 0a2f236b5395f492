// Faults that only waveform generators have.
#include "generator_rig.hpp"
#include <test_support/mains.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class AnyGenerator : public testing::TestWithParam<GeneratorCase> {
 protected:
  AnyGenerator() { mains_.duration_s = 0.15; }

  bool has_error_queue() const { return !rig_.instrument.dialect.next_error.empty(); }

  // The error of a run in which `fault` happens before `call`; the output is off afterwards.
  std::string run_with(const std::function<void()>& fault, const std::string& call) {
    std::string error = first_error_of_run(*source_, mains_, [&](const std::string& next) {
      if (next == call) {
        fault();
      }
    });
    EXPECT_TRUE(source_->make_safe().ok());
    EXPECT_FALSE(rig_.output_is_on());
    return error;
  }
  std::string run_with(const emulation::GeneratorFaults& faults, const std::string& call) {
    return run_with([&] { rig_.generator().set_faults(faults); }, call);
  }

  void expect_stored(const scpi::Plan& plan) {
    const auto stored = rig_.generator().waveform(rig_.generator().settings().waveform);
    ASSERT_TRUE(stored);
    ASSERT_EQ(stored->size(), plan.codes.size());
    const double middle = rig_.instrument.middle_code();
    const double scale = 32767.0 / rig_.instrument.full_scale_code();
    for (std::size_t i = 0; i < stored->size(); ++i) {
      // The emulator rounds to its own scale.
      ASSERT_NEAR((*stored)[i], scale * (plan.codes[i] - middle), 4.0) << i;
    }
  }

  // Codes with a byte 0x0A.
  static std::ptrdiff_t newlines_in(const std::vector<std::int32_t>& codes) {
    return std::count_if(codes.begin(), codes.end(), [](std::int32_t code) {
      const auto bytes = static_cast<std::uint32_t>(code);
      return (bytes & 0xFFU) == 0x0AU || (bytes >> 8U & 0xFFU) == 0x0AU;
    });
  }

  std::string prepared(GeneratorRig& rig) {
    const auto source = rig.make_source();
    const auto played = source->prepare(mains_);
    return played.ok() ? "" : played.error();
  }

  Mains mains_;
  GeneratorRig rig_{GetParam()};
  std::shared_ptr<source::Source> source_ = rig_.make_source();
};

INSTANTIATE_TEST_SUITE_P(Of, AnyGenerator, testing::ValuesIn(kGeneratorCases),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_P(AnyGenerator, StatesItsLimits) {
  const source::Limits limits = source_->limits();
  EXPECT_EQ(limits.kind, source::Kind::kLoaded);
  EXPECT_THAT(limits.name, AllOf(HasSubstr(rig_.instrument.title), HasSubstr("tcp://127.0.0.1")));
  // The voltage limit of 253 V.
  EXPECT_LE(limits.full_scale_pu, 1.1);
  const double step_pu = 0.5 * rig_.instrument.amplitude.resolution_vpp *
                         rig_.options.plan.wiring.gain / (std::sqrt(2.0) * 230.0);
  EXPECT_GT(limits.full_scale_pu, 1.1 - step_pu);
  mains_.level_pu = 1.11;
  EXPECT_THAT(source_->prepare(mains_).error(), HasSubstr("beyond"));
  EXPECT_EQ(rig_.commands(), 0U) << "refused before anything is sent";
}

TEST_P(AnyGenerator, StoresTheWaveformAsItWasPlanned) {
  ASSERT_TRUE(source_->prepare(mains_).ok());
  const auto plan = scpi::make_plan(mains_, rig_.instrument, rig_.options.plan);
  ASSERT_TRUE(plan.ok());
  const emulation::GeneratorSettings settings = rig_.generator().settings();
  EXPECT_NEAR(settings.amplitude_vpp, plan.value().amplitude_vpp, 1e-9);
  EXPECT_TRUE(settings.burst_on);
  EXPECT_EQ(settings.burst_cycles, 1.0);
  EXPECT_EQ(settings.trigger, emulation::TriggerSource::kManual);
  expect_stored(plan.value());
}

// A byte 0x0A ends a line. An instrument that stops reading there is sent a waveform without it.
TEST_P(AnyGenerator, StoresAWaveformWhoseBytesContainNewlines) {
  scpi::Instrument reads_all = rig_.instrument;
  reads_all.quirks.erase(
      std::remove(reads_all.quirks.begin(), reads_all.quirks.end(), scpi::Quirk::kAvoidNewline),
      reads_all.quirks.end());
  const auto wanted = scpi::make_plan(mains_, reads_all, rig_.options.plan);
  ASSERT_TRUE(wanted.ok());
  EXPECT_GE(newlines_in(wanted.value().codes), 10);
  const auto plan = scpi::make_plan(mains_, rig_.instrument, rig_.options.plan);
  ASSERT_TRUE(plan.ok());
  if (rig_.instrument.has(scpi::Quirk::kAvoidNewline)) {
    EXPECT_EQ(newlines_in(plan.value().codes), 0);
    EXPECT_GT(plan.value().largest_nudge, 0);
  } else {
    EXPECT_EQ(plan.value().codes, wanted.value().codes);
    EXPECT_EQ(plan.value().largest_nudge, 0);
  }
  ASSERT_TRUE(source_->prepare(mains_).ok());
  expect_stored(plan.value());
}

TEST_P(AnyGenerator, ThatHasNoRoomForTheWaveformEndsPrepare) {
  emulation::GeneratorFaults faults;
  faults.memory_full = true;
  EXPECT_THAT(run_with(faults, "prepare"),
              has_error_queue()
                  ? testing::ContainsRegex("reports an error after the upload: .*[Mm]emory")
                  : testing::ContainsRegex("cannot be read back: .*no answer to \"WVDT. USER,"));
}

TEST_P(AnyGenerator, ThatClampsTheAmplitudeSilentlyIsFound) {
  emulation::GeneratorFaults faults;
  faults.silent_limit_vpp = 5.0;
  EXPECT_THAT(run_with(faults, "prepare"),
              testing::ContainsRegex("amplitude is [+]?5.*, but 6[.]5"));
}

TEST_P(AnyGenerator, MayHaveOldErrorsButNoNewOnes) {
  emulation::GeneratorFaults faults;
  faults.error_queue_full = true;
  EXPECT_EQ(run_with(faults, "prepare"), "");
  const std::string error = run_with(faults, "energise");
  if (has_error_queue()) {
    EXPECT_THAT(error, HasSubstr("reports an error after the trigger: "));
  } else {
    EXPECT_EQ(error, "");
  }
}

TEST_P(AnyGenerator, WhoseSettingsAreChangedAtTheFrontPanelEndsTheRun) {
  const struct {
    const char* setting;
    emulation::PanelChange change;
  } cases[] = {
      {"output", {false, {}, {}, {}, {}, {}, {}, {}}},
      {"function", {{}, emulation::GeneratorFunction::kSquare, {}, {}, {}, {}, {}, {}}},
      {"amplitude", {{}, {}, {}, 6.6, {}, {}, {}, {}}},
      {"offset", {{}, {}, {}, {}, 0.5, {}, {}, {}}},
      // Some models display half the amplitude into a load, which may be asked first.
      {"(load|amplitude)", {{}, {}, {}, {}, {}, 50.0, {}, {}}},
      {"burst", {{}, {}, {}, {}, {}, {}, {}, false}},
  };
  for (const auto& one : cases) {
    for (const char* const call : {"hold", "advance"}) {
      EXPECT_THAT(run_with([&] { rig_.generator().press(one.change); }, call),
                  AllOf(testing::ContainsRegex(one.setting), HasSubstr("was set")))
          << one.setting << " before " << call;
    }
  }
}

// All questions in a row would take longer than the margin.
// The waveform is on its way for longer than an answer may take.
TEST_P(AnyGenerator, MayTakeTheWaveformAtTheSlowestRateThatIsStated) {
  emulation::GeneratorFaults faults;
  faults.receive_bytes_s = 40e3;
  rig_.generator().set_faults(faults);
  rig_.instrument.timing.upload_bytes_s = 20e3;
  EXPECT_EQ(prepared(rig_), "");

  rig_.instrument.timing.upload_bytes_s = 1e6;
  rig_.instrument.timing.answer_s = 0.1;
  EXPECT_THAT(prepared(rig_), HasSubstr("no answer to"));
}

TEST_P(AnyGenerator, ThatAnswersAfterAFifthOfASecondIsPlayedToTheEnd) {
  rig_.instrument.timing.answer_s = 2.0;
  rig_.options.plan.margin_s = 1.0;
  source_ = rig_.make_source();
  emulation::GeneratorFaults faults;
  faults.answer_delay_s = 0.2;
  EXPECT_EQ(run_with(faults, "energise"), "");
}

TEST_P(AnyGenerator, WhoseOutputStaysOnIsReported) {
  emulation::GeneratorFaults faults;
  faults.ignores_output_off = true;
  static_cast<void>(first_error_of_run(*source_, mains_, [&](const std::string& call) {
    if (call == "start") {
      rig_.generator().set_faults(faults);
    }
  }));
  const drivers::Status safe = source_->make_safe();
  ASSERT_FALSE(safe.ok());
  EXPECT_THAT(safe.error(), AllOf(HasSubstr("output state unknown"),
                                  HasSubstr("the output is on, but off was set"),
                                  HasSubstr("Switch the generator off by hand")));
  EXPECT_TRUE(rig_.output_is_on());
}

TEST_P(AnyGenerator, IsStartedInTimeOrNotAtAll) {
  ASSERT_TRUE(source_->prepare(mains_).ok());
  ASSERT_TRUE(source_->energise().ok());
  EXPECT_TRUE(source_->hold().ok());
  std::this_thread::sleep_for(std::chrono::duration<double>(rig_.options.plan.margin_s + 0.1));
  EXPECT_THAT(source_->start().error(), HasSubstr("the margin of 0.25 s is too short"));
  EXPECT_TRUE(source_->make_safe().ok());
}

TEST_P(AnyGenerator, PlacesTheStimulusOnTheHostsClock) {
  EXPECT_FALSE(source_->host_clock());
  ASSERT_TRUE(source_->prepare(mains_).ok());
  const auto before = std::chrono::steady_clock::now();
  ASSERT_TRUE(source_->energise().ok());
  const auto clock = source_->host_clock();
  ASSERT_TRUE(clock);
  EXPECT_DOUBLE_EQ(clock->tick_s, 1.0 / 8000.0);
  // Rise and margin after the trigger.
  const auto after = [](std::chrono::steady_clock::time_point time, double later_s) {
    return time + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                      std::chrono::duration<double>(later_s));
  };
  const scpi::PlanOptions& plan = rig_.options.plan;
  EXPECT_GT(clock->tick_0, after(before, plan.rise_s + plan.margin_s));
  EXPECT_LT(clock->tick_0, after(std::chrono::steady_clock::now(), plan.margin_s + 0.02));
  EXPECT_GE(clock->uncertainty_s, rig_.instrument.accuracy.trigger_uncertainty_s);
  EXPECT_LT(clock->uncertainty_s, 1.0);
  EXPECT_TRUE(source_->make_safe().ok());
}

}  // namespace
}  // namespace gsbench::test
