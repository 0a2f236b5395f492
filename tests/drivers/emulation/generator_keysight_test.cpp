// An emulated Keysight 33522B: waveforms, triggers, the error queue.
#include "generator_bench.hpp"
#include <test_support/waiting.hpp>

#include <cstring>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::Between;
using emulation::Generator;
using emulation::GeneratorFaults;
using emulation::GeneratorFunction;
using emulation::GeneratorModel;
using emulation::GeneratorOptions;
using testing::HasSubstr;
using testing::Optional;
using testing::StartsWith;
using Codes = std::vector<std::int16_t>;

class KeysightGenerator : public testing::Test {
 protected:
  void upload(const std::string& name, const Codes& codes) {
    bench.say({"FORM:BORD SWAP", "DATA:ARB:DAC " + name + ", " + block(bytes_of(codes))});
  }

  GeneratorBench bench{GeneratorModel::k33522b};
};

TEST_F(KeysightGenerator, AnswersAsTheManualPrintsIt) {
  EXPECT_THAT(bench.ask("*IDN?"), HasSubstr(",33522B,"));
  EXPECT_EQ(bench.ask("OUTP?"), "0");
  EXPECT_EQ(bench.ask("FREQ?"), "+1.000000000000000E+03");
  EXPECT_EQ(bench.ask("VOLT?"), "+1.000000000000000E-01");
  EXPECT_EQ(bench.ask("OUTP1:LOAD?"), "+5.000000000000000E+01");
  EXPECT_EQ(bench.ask("FUNC?"), "SIN");
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
}

TEST_F(KeysightGenerator, ReadsChainsWithRelativeHeaders) {
  bench.say({"BURS:MODE TRIG;NCYC 3;:TRIG:SOUR BUS;:sour1:burst:state on"});
  EXPECT_DOUBLE_EQ(bench.settings().burst_cycles, 3);
  EXPECT_TRUE(bench.settings().burst_on);
  EXPECT_EQ(bench.ask("BURS:STAT?;NCYC?;:TRIG:SOUR?"), "1;+3.000000000000000E+00;BUS");
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  // FREQ is no part of BURSt.
  bench.say({"BURS:NCYC 2;FREQ 50"});
  EXPECT_EQ(bench.ask("SYST:ERR?"), "-113,\"Undefined header\"");
}

TEST_F(KeysightGenerator, ClipsWhatIsOutOfRangeAndReportsIt) {
  bench.say({"VOLT 12"});
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 10);
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-222,"));
  bench.say({"OUTP:LOAD INF"});
  EXPECT_EQ(bench.ask("VOLT?"), "+2.000000000000000E+01");
  bench.say({"OUTP:LOAD 50", "VOLT:UNIT VRMS", "VOLT 1"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, std::sqrt(8.0), 1e-12);
  bench.say({"VOLT:UNIT VPP", "VOLT:LOW -1", "VOLT:HIGH 2"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, 3, 1e-12);
  EXPECT_NEAR(bench.settings().offset_v, 0.5, 1e-12);
}

TEST_F(KeysightGenerator, TakesCodesInEitherByteOrder) {
  const Codes codes{0, 10, 2560, -10, 32767, -32767, 0x3b0a, 1};
  upload("little", codes);
  bench.say({"FORM:BORD NORM", "DATA:ARB:DAC big, " + block(bytes_of(codes, true)),
             "DATA:ARB:DAC text, 0, 10, 2560, -10, 32767, -32767, 15114, 1"});
  EXPECT_THAT(bench.generator->waveform("little"), Optional(codes));
  EXPECT_THAT(bench.generator->waveform("big"), Optional(codes));
  EXPECT_THAT(bench.generator->waveform("text"), Optional(codes));
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  EXPECT_EQ(bench.ask("DATA:VOL:FREE?"), "+999976");
}

TEST_F(KeysightGenerator, TakesNumbersOfSinglePrecision) {
  std::string bytes(32, '\0');
  for (std::size_t i = 0; i < 8; ++i) {
    const float value = static_cast<float>(i) / 7;
    std::memcpy(&bytes[4 * i], &value, 4);
  }
  bench.say({"FORM:BORD SWAP", "DATA:ARB part," + block(bytes)});
  const auto stored = bench.generator->waveform("part");
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->front(), 0);
  EXPECT_EQ(stored->at(3), 14043);
  EXPECT_EQ(stored->back(), 32767);
  bench.say({"DATA:ARB more, 0, 0, 0, 0, 0, 0, 0, 1.01"});
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-222,"));
  EXPECT_FALSE(bench.generator->waveform("more"));
}

TEST_F(KeysightGenerator, RefusesANameThatIsLoadedUntilItIsCleared) {
  upload("same", Codes(8, 1));
  upload("same", Codes(8, 2));
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+786,\"Specified arb waveform already exists\"");
  EXPECT_THAT(bench.generator->waveform("same"), Optional(Codes(8, 1)));
  bench.say({"DATA:VOL:CLE"});
  upload("same", Codes(8, 2));
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  EXPECT_THAT(bench.generator->waveform("same"), Optional(Codes(8, 2)));
}

TEST_F(KeysightGenerator, KeepsVolatileWaveformsAfterAResetButNotWithoutPower) {
  upload("same", Codes(8, 1));
  bench.say({"*RST"});
  upload("same", Codes(8, 2));
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("+786,"));
  bench.generator->reset_now(std::chrono::milliseconds(1));
  EXPECT_FALSE(bench.generator->waveform("same"));
}

TEST_F(KeysightGenerator, HoldsEightToAMillionPoints) {
  upload("few", Codes(7, 1));
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-222,"));
  upload("most", Codes(1'000'000, 0x0a0a));
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  EXPECT_EQ(bench.ask("DATA:ATTR:POIN? most"), "+1000000");
  upload("more", Codes(8, 1));
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("+781,"));
}

TEST_F(KeysightGenerator, SelectsOnlyWhatIsLoaded) {
  bench.say({"FUNC:ARB none"});
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("+785,"));
  EXPECT_EQ(bench.ask("FUNC:ARB?"), "\"INT:\\BUILTIN\\EXP_RISE.ARB\"");
  upload("mine", Codes(8, 1));
  bench.say({"FUNC:ARB \"mine\"", "FUNC:ARB:SRAT 8000", "FUNC:ARB:FILT OFF", "FUNC ARB"});
  EXPECT_EQ(bench.ask("FUNC:ARB?"), "\"mine\"");
  EXPECT_EQ(bench.ask("FUNC?"), "ARB");
  EXPECT_EQ(bench.ask("FUNC:ARB:SRAT?"), "+8.000000000000000E+03");
  EXPECT_EQ(bench.ask("FUNC:ARB:FILT?"), "OFF");
  EXPECT_EQ(bench.ask("FUNC:ARB:ADV?"), "SRAT");
  EXPECT_EQ(bench.settings().between, Between::kHold);
}

TEST_F(KeysightGenerator, KeepsTwentyErrorsAndReportsTheOverflow) {
  for (int i = 0; i < 25; ++i) {
    bench.client->say("NONE");
  }
  for (int i = 0; i < 19; ++i) {
    EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-113,"));
  }
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-350,"));
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  GeneratorFaults faults;
  faults.error_queue_full = true;
  bench.generator->set_faults(faults);
  bench.say({"*CLS"});
  EXPECT_EQ(bench.ask("SYST:ERR?"), "+0,\"No error\"");
  bench.generator->set_faults(faults);
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-100,"));
}

TEST_F(KeysightGenerator, PlaysABurstAfterABusTrigger) {
  upload("hill", {0, 16000, 32000, 16000, 0, 0, 0, 0});
  bench.say({"OUTP:LOAD INF", "VOLT 4", "FUNC:ARB hill", "FUNC:ARB:FILT OFF", "FUNC:ARB:SRAT 640",
             "FUNC ARB", "BURS:MODE TRIG", "BURS:NCYC 2", "TRIG:SOUR BUS", "BURS:STAT ON",
             "OUTP ON"});
  EXPECT_NEAR(bench.mean(2000), 0.0, 1e-9);
  bench.client->say("*TRG");
  EXPECT_EQ(bench.ask("OUTP?"), "1");  // *OPC? would wait for the end of the burst
  const std::vector<double> volts = bench.output(3000);
  EXPECT_NEAR(volts[250], 2.0 * 32000 / 32767, 1e-6);
  EXPECT_NEAR(volts[1050], 2.0 * 32000 / 32767, 1e-6);
  EXPECT_NEAR(volts[1850], 0.0, 1e-9);
  bench.say({"TRIG:SOUR IMM", "*TRG"});
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-211,"));
}

TEST_F(KeysightGenerator, StopsABurstOnAbort) {
  bench.say({"OUTP:LOAD INF", "VOLT 4", "FUNC SQU", "FREQ 0.001", "BURS:NCYC 1", "TRIG:SOUR BUS",
             "BURS:PHAS 180", "BURS:STAT ON", "OUTP ON"});
  EXPECT_NEAR(bench.mean(100), -2.0, 1e-6);
  bench.client->say("BURS:PHAS 0;:*TRG");
  EXPECT_EQ(bench.ask("OUTP?"), "1");
  EXPECT_NEAR(bench.mean(100), 2.0, 1e-6);
  EXPECT_TRUE(bench.generator->is_playing());
  bench.say({"ABOR"});
  EXPECT_FALSE(bench.generator->is_playing());
}

// *OPC? is answered at the end of a burst, and nothing else is executed before.
TEST(KeysightGeneratorInRealTime, AnswersOperationCompleteAtTheEndOfTheBurst) {
  GeneratorOptions options;
  options.model = GeneratorModel::k33522b;
  const auto generator = Generator::start(options).take();
  GeneratorClient client(generator->port());
  for (const char* line : {"FREQ 2", "BURS:NCYC 1", "TRIG:SOUR BUS", "BURS:STAT ON", "OUTP ON"}) {
    client.say(line);
  }
  const std::int64_t before = options.time.now();
  client.say("*TRG");
  EXPECT_EQ(client.ask("*OPC?"), "1");
  EXPECT_GE(options.time.now() - before, 32000);
  EXPECT_FALSE(generator->is_playing());
}

TEST_F(KeysightGenerator, HangsOnABlockThatIsTooShort) {
  bench.client->say("DATA:ARB:DAC late, #3400too short");
  bench.client->say("OUTP ON");
  ASSERT_TRUE(bench.client->line(std::chrono::seconds(4)).empty());
  EXPECT_THAT(bench.ask("SYST:ERR?"), StartsWith("-161,"));
  EXPECT_FALSE(bench.generator->output_is_on());
}

// APPLy switches the output on and the burst off.
TEST_F(KeysightGenerator, AppliesAWaveform) {
  bench.say({"BURS:STAT ON", "APPL:SQU 50,2,0.5"});
  EXPECT_EQ(bench.settings().function, GeneratorFunction::kSquare);
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 50);
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 2);
  EXPECT_FALSE(bench.settings().burst_on);
  EXPECT_TRUE(bench.generator->output_is_on());
  bench.say({"*RST"});
  EXPECT_FALSE(bench.generator->output_is_on());
}

}  // namespace
}  // namespace gsbench::test
