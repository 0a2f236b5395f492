// Faults of emulated generators: their answers, connections, settings and power.
#include "generator_bench.hpp"
#include <test_support/waiting.hpp>

#include <functional>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using namespace std::chrono_literals;
using emulation::GeneratorFaults;
using emulation::GeneratorModel;
using testing::Each;

class GeneratorFaultsOf : public testing::TestWithParam<GeneratorModel> {
 protected:
  void set(const std::function<void(GeneratorFaults&)>& edit) {
    GeneratorFaults faults;
    edit(faults);
    bench.generator->set_faults(faults);
  }
  bool reconnects() {
    return until([&] {
      bench.client = std::make_unique<GeneratorClient>(bench.generator->port());
      return bench.client->is_open();
    });
  }

  GeneratorBench bench{GetParam()};
};

TEST_P(GeneratorFaultsOf, AnswersNothing) {
  set([](GeneratorFaults& faults) { faults.silent = true; });
  bench.client->say("*IDN?");
  EXPECT_EQ(bench.client->line(100ms), "");
  set([](GeneratorFaults&) {});
  EXPECT_EQ(bench.ask("*OPC?"), "1");
}

TEST_P(GeneratorFaultsOf, AnswersLate) {
  set([](GeneratorFaults& faults) { faults.answer_delay_s = 1.0; });
  bench.client->say("*OPC?");
  EXPECT_EQ(bench.client->line(100ms), "");
  EXPECT_EQ(bench.client->line(), "1");
}

TEST_P(GeneratorFaultsOf, AnswersHalfAndThenNothing) {
  const std::string whole = bench.ask("*IDN?");
  set([](GeneratorFaults& faults) { faults.half_answers = true; });
  bench.client->say("*IDN?");
  bench.client->say("*IDN?");
  const std::string half = whole.substr(0, (whole.size() + 1) / 2);
  EXPECT_EQ(bench.client->bytes(half.size()), half);
  EXPECT_EQ(bench.client->line(100ms), "");
}

TEST_P(GeneratorFaultsOf, AnswersGarbage) {
  const std::string whole = bench.ask("*IDN?");
  set([](GeneratorFaults& faults) { faults.garbage_answers = true; });
  const std::string garbage = bench.ask("*IDN?");
  EXPECT_EQ(garbage.size(), whole.size());
  EXPECT_EQ(garbage.find_first_of("0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"), std::string::npos);
}

TEST_P(GeneratorFaultsOf, HasAnotherIdentity) {
  set([](GeneratorFaults& faults) { faults.identity = "ACME,X1,0,0"; });
  EXPECT_EQ(bench.ask("*IDN?"), "ACME,X1,0,0");
}

TEST_P(GeneratorFaultsOf, DropsTheConnectionAtAMessageAndDoesNotExecuteIt) {
  set([](GeneratorFaults& faults) { faults.drop_at_message = 2; });
  bench.client->say("*CLS");
  bench.client->say("*OPC?");
  EXPECT_TRUE(bench.client->hangs_up());
  EXPECT_TRUE(reconnects());
  EXPECT_EQ(bench.ask("*OPC?"), "1");
}

TEST_P(GeneratorFaultsOf, DropsTheConnectionAtAByte) {
  set([](GeneratorFaults& faults) { faults.drop_at_byte = 20; });
  bench.client->send("C1:WVDT WVNM,name,WAVEDATA,aabb");
  EXPECT_TRUE(bench.client->hangs_up());
  EXPECT_TRUE(reconnects());
}

TEST_P(GeneratorFaultsOf, ClampsAmplitudesInSilence) {
  set([](GeneratorFaults& faults) { faults.silent_limit_vpp = 0.5; });
  bench.say({"C1:BSWV AMP,3", ":SOUR1:VOLT 3"});
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 0.5);
}

TEST_P(GeneratorFaultsOf, KeepsAnOutputOnWhoseRelayIsStuck) {
  bench.say({"C1:OUTP ON", ":OUTP1 ON"});
  set([](GeneratorFaults& faults) { faults.ignores_output_off = true; });
  bench.say({"C1:OUTP OFF", ":OUTP1 OFF"});
  EXPECT_TRUE(bench.generator->output_is_on());
}

TEST_P(GeneratorFaultsOf, StartsWithTheOutputOffAfterAPowerCycle) {
  bench.say({"C1:OUTP ON", ":OUTP1 ON"});
  bench.output(10);
  bench.generator->reset_now(1000ms);
  EXPECT_FALSE(bench.generator->output_is_on());
  EXPECT_TRUE(bench.client->hangs_up());
  EXPECT_FALSE(GeneratorClient(bench.generator->port()).is_open());
  EXPECT_THAT(bench.output(10), Each(0.0));
  EXPECT_TRUE(reconnects());
  EXPECT_EQ(bench.ask("*OPC?"), "1");
}

TEST_P(GeneratorFaultsOf, GoesOnPlayingWhenUnplugged) {
  bench.say({"C1:OUTP ON", ":OUTP1 ON"});
  bench.generator->unplug();
  EXPECT_TRUE(bench.client->hangs_up());
  EXPECT_FALSE(GeneratorClient(bench.generator->port()).is_open());
  EXPECT_TRUE(bench.generator->output_is_on());
  ASSERT_TRUE(bench.generator->plug_in().ok());
  EXPECT_TRUE(reconnects());
  EXPECT_EQ(bench.ask("*OPC?"), "1");
}

TEST_P(GeneratorFaultsOf, ServesASecondClientWhenTheFirstHasGone) {
  GeneratorClient second(bench.generator->port());
  second.say("*OPC?");
  EXPECT_EQ(second.line(100ms), "");
  bench.client.reset();
  EXPECT_EQ(second.line(), "1");
}

INSTANTIATE_TEST_SUITE_P(EveryModel, GeneratorFaultsOf,
                         testing::Values(GeneratorModel::kSdg1032x, GeneratorModel::kSdg2042x,
                                         GeneratorModel::kDg1062z, GeneratorModel::k33522b));

}  // namespace
}  // namespace gsbench::test
