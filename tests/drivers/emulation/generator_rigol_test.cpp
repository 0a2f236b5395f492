// An emulated Rigol DG1062Z: packets, what an upload changes, errors.
#include "generator_bench.hpp"

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::GeneratorFaults;
using emulation::GeneratorFunction;
using emulation::GeneratorModel;
using emulation::PointRate;
using testing::StartsWith;
using Codes = std::vector<std::int16_t>;

class RigolGenerator : public testing::Test {
 protected:
  static std::string packet(const std::string& flag, const Codes& codes) {
    return ":SOUR1:DATA:DAC16 VOLATILE," + flag + "," + block(bytes_of(codes));
  }
  std::size_t points() const {
    const auto found = bench.generator->waveform("VOLATILE");
    return found ? found->size() : 0;
  }

  GeneratorBench bench{GeneratorModel::kDg1062z};
};

TEST_F(RigolGenerator, AnswersInScientificNotation) {
  EXPECT_THAT(bench.ask("*IDN?"), StartsWith("Rigol Technologies,DG1062Z,"));
  EXPECT_EQ(bench.ask(":SOUR1:FREQ?"), "1.000000E+03");
  EXPECT_EQ(bench.ask(":OUTP1:LOAD?"), "5.000000E+01");
  EXPECT_EQ(bench.ask(":OUTP1?"), "OFF");
  bench.say({":OUTP1:IMP INF"});
  EXPECT_EQ(bench.ask(":OUTP1:LOAD?"), "9.900000E+37");
  EXPECT_EQ(bench.ask(":SOUR1:VOLT?"), "1.000000E+01");
}

TEST_F(RigolGenerator, ReadsChainsShortAndLongForms) {
  bench.say({":source1:voltage 2;voltage:offset 0.5;:OUTPUT1:STATE ON", "SOUR1:FREQ 50;VOLT 3"});
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 50);
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 3);
  EXPECT_DOUBLE_EQ(bench.settings().offset_v, 0.5);
  EXPECT_TRUE(bench.generator->output_is_on());
  EXPECT_EQ(bench.ask(":SOUR1:FREQ?;:OUTP1?"), "5.000000E+01;ON");
  EXPECT_EQ(bench.ask("SYST:ERR?"), "0,\"No error\"");
}

TEST_F(RigolGenerator, RefusesWhatIsOutOfRangeAndKeepsTheSetting) {
  bench.say({":SOUR1:VOLT 2", ":SOUR1:VOLT 25"});
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "-222,\"Data out of range\"");
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 2);
  bench.say({":SOUR1:NONE 1"});
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "-113,\"Undefined header\"");
  bench.say({":SOUR1:DATA:DAC VOLATILE,8192,16383"});
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "-220,\"Parameter error\"");
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "0,\"No error\"");
}

TEST_F(RigolGenerator, JoinsPacketsOfAnyBytesAndSwitchesToThem) {
  Codes codes(5000);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] = static_cast<std::int16_t>(i * 3);  // with bytes such as newline, ';', '#', '"'
  }
  const Codes first(codes.begin(), codes.begin() + 3000);
  const Codes second(codes.begin() + 3000, codes.end());
  bench.say({":SOUR1:BURS ON", packet("CON", first)});
  EXPECT_EQ(points(), 0U);
  EXPECT_EQ(bench.settings().function, GeneratorFunction::kSine);
  bench.say({packet("END", second)});
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "0,\"No error\"");
  EXPECT_EQ(bench.ask(":SOUR1:DATA:POIN? VOLATILE"), "5000");
  EXPECT_EQ(bench.ask(":SOUR1:FUNC?"), "USER");
  EXPECT_EQ(bench.ask(":SOUR1:FUNC:ARB:MODE?"), "SRATE");
  EXPECT_EQ(bench.ask(":SOUR1:BURS?"), "OFF");
  EXPECT_EQ(bench.ask(":OUTP1?"), "OFF");
  const auto stored = bench.generator->waveform("VOLATILE");
  ASSERT_TRUE(stored);
  EXPECT_EQ(stored->front(), -32767);
  EXPECT_NEAR(stored->at(4999), 14997 * 2 * 32767.0 / 16383 - 32767, 1);
}

// Other clients wait between packets, or for *OPC?.
TEST_F(RigolGenerator, LosesAPacketThatFollowsAtOnce) {
  const Codes codes(1000, 8192);
  bench.client->send(packet("CON", codes) + "\n" + packet("CON", codes) + "\n");
  bench.say({});
  bench.say({packet("END", codes)});
  EXPECT_EQ(points(), 2000U);
  EXPECT_EQ(bench.ask(":SYST:ERR?"), "0,\"No error\"");
}

TEST_F(RigolGenerator, TakesPacketsOfEightTo8192Points) {
  bench.say({packet("END", Codes(7, 0))});
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-220,"));
  bench.say({packet("END", Codes(8193, 0))});
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-223,"));
  bench.say({packet("END", Codes(8, 0x4000))});
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-222,"));
  bench.say({packet("END", Codes(8192, 0x3fff))});
  EXPECT_EQ(points(), 8192U);
}

TEST_F(RigolGenerator, PlaysFourteenBitsAroundTheOffset) {
  bench.say({":OUTP1:LOAD INF", ":SOUR1:VOLT 4", ":SOUR1:VOLT:OFFS 1", packet("END", Codes(8, 0)),
             ":OUTP1 ON"});
  EXPECT_NEAR(bench.mean(100), -1.0, 1e-6);
  bench.say({packet("END", Codes(8, 0x3fff))});
  EXPECT_NEAR(bench.mean(100), 3.0, 1e-6);
  bench.say({packet("END", Codes(8, 0x2000))});
  EXPECT_NEAR(bench.mean(100), 1.0 + 2.0 / 16383, 1e-6);
}

TEST_F(RigolGenerator, PlaysABurstAfterAManualTriggerWithTheOutputOn) {
  Codes hill(64, 8192);
  hill[0] = 0;
  hill[32] = 16383;
  bench.say({":OUTP1:LOAD INF", ":SOUR1:VOLT 4", packet("END", hill), ":SOUR1:FUNC:ARB:SRAT 6400",
             ":SOUR1:BURS:MODE TRIG", ":SOUR1:BURS:NCYC 1", ":SOUR1:BURS:TRIG:SOUR MAN",
             ":SOUR1:BURS ON", ":SOUR1:BURS:TRIG"});
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-211,"));  // the output is off
  bench.say({":OUTP1 ON"});
  EXPECT_NEAR(bench.mean(1000), -2.0, 1e-6);  // the first point
  bench.say({":SOUR1:BURS:IDLE CENTER"});
  EXPECT_NEAR(bench.mean(1000), 0.0, 1e-6);
  bench.say({"*TRG"});
  const std::vector<double> volts = bench.output(1000);
  EXPECT_NEAR(volts[5], -2.0, 1e-6);
  EXPECT_NEAR(volts[325], 2.0, 1e-6);
  EXPECT_NEAR(volts[700], 0.0, 1e-6);
}

TEST_F(RigolGenerator, StopsAnIncompleteBlockAfterAWhile) {
  bench.client->say(":SOUR1:DATA:DAC16 VOLATILE,END,#520000too short");
  // The next commands are taken for points, until the rest does not come.
  bench.client->say(":OUTP1 ON");
  ASSERT_TRUE(bench.client->line(std::chrono::seconds(4)).empty());
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-161,"));
  EXPECT_FALSE(bench.generator->output_is_on());
}

TEST_F(RigolGenerator, ReportsFullMemory) {
  GeneratorFaults faults;
  faults.memory_full = true;
  bench.generator->set_faults(faults);
  bench.say({packet("END", Codes(8, 0))});
  EXPECT_THAT(bench.ask(":SYST:ERR?"), StartsWith("-321,"));
}

TEST_F(RigolGenerator, AppliesAWaveform) {
  bench.say({":SOUR1:APPL:ARB 1000,2,0.5"});
  EXPECT_EQ(bench.settings().point_rate, PointRate::kSampleRate);
  EXPECT_DOUBLE_EQ(bench.settings().sample_rate_hz, 1000);
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 2);
  bench.say({":SOUR1:APPL:SIN 50,1,0", ":SOUR1:DATA VOLATILE,-1,-0.5,0,0.5,1"});
  EXPECT_EQ(points(), 5U);
  EXPECT_FALSE(bench.generator->output_is_on());
}

}  // namespace
}  // namespace gsbench::test
