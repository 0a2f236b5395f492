// The fixture of the conformance suite of drivers of instruments: whatever happens to the
// instrument or to the connection, the output is off afterwards wherever the bench can reach it.
// Otherwise the error says that its state is unknown.
#pragma once

#include "instrument_rig.hpp"
#include <test_support/mains.hpp>

#include <functional>
#include <memory>
#include <string>

#include <gmock/gmock.h>

namespace gsbench::test {

struct RigCase {
  const char* name;
  std::unique_ptr<InstrumentRig> (*make)();
};

class AnyInstrument : public testing::TestWithParam<RigCase> {
 protected:
  AnyInstrument() { mains_.duration_s = 0.15; }

  void new_rig() {
    source_.reset();
    rig_ = GetParam().make();
    source_ = rig_->make_source();
  }

  // The run fails if `fault` happens before `call`. Returns the error.
  std::string run_with(const std::function<void()>& fault, const std::string& call) {
    bool happened = false;
    std::string error = first_error_of_run(*source_, mains_, [&](const std::string& next) {
      if (next == call && !happened) {
        happened = true;
        fault();
      }
    });
    EXPECT_TRUE(happened) << call << ": " << error;
    return error;
  }

  // Whether it could be made safe. Either way, what the source says is so.
  bool make_safe(source::Source& source) {
    const drivers::Status safe = source.make_safe();
    if (safe.ok()) {
      EXPECT_FALSE(rig_->output_is_on());
    } else {
      EXPECT_THAT(safe.error(),
                  testing::AllOf(testing::HasSubstr("output state unknown"),
                                 testing::HasSubstr("by itself"), testing::HasSubstr("by hand")));
    }
    return safe.ok();
  }

  void expect_off_after_run() {
    if (abilities_.stop_asks_and_switches_off) {
      EXPECT_FALSE(rig_->output_is_on());
    }
    EXPECT_TRUE(make_safe(*source_));
  }
  bool must_fail(const std::string& call) const {
    return call != "stop" || abilities_.stop_asks_and_switches_off;
  }

  // As `gsbench safe`: without having prepared anything.
  void expect_reachable() {
    source_.reset();
    EXPECT_TRUE(make_safe(*rig_->make_source()));
    EXPECT_FALSE(rig_->output_is_on());
  }

  Mains mains_;
  std::unique_ptr<InstrumentRig> rig_ = GetParam().make();
  std::shared_ptr<source::Source> source_ = rig_->make_source();
  const Abilities abilities_ = rig_->abilities();
};

inline std::string name_of(const testing::TestParamInfo<RigCase>& rig) {
  return rig.param.name;
}

}  // namespace gsbench::test
