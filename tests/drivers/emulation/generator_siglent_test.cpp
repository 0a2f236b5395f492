// Emulated Siglent SDG1032X and SDG2042X: syntax, waveforms, and what they do without a sign.
#include "generator_bench.hpp"

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::Between;
using emulation::GeneratorFaults;
using emulation::GeneratorFunction;
using emulation::GeneratorModel;
using emulation::PointRate;
using emulation::TriggerSource;
using testing::ElementsAre;
using testing::Optional;
using testing::StartsWith;
using Codes = std::vector<std::int16_t>;

class SiglentGenerator : public testing::Test {
 protected:
  void upload(const std::string& name, const Codes& codes) {
    const std::string bytes = bytes_of(codes);
    bench.client->say("C1:WVDT WVNM," + name + ",LENGTH," + std::to_string(bytes.size()) +
                      "B,WAVEDATA," + bytes);
  }
  void play(const std::string& name) { bench.say({"C1:ARWV NAME," + name, "C1:BSWV WVTP,ARB"}); }

  GeneratorBench bench{GeneratorModel::kSdg2042x};
};

class SmallSiglentGenerator : public SiglentGenerator {
 protected:
  SmallSiglentGenerator() { bench = GeneratorBench(GeneratorModel::kSdg1032x); }
};

TEST_F(SiglentGenerator, AnswersWithUnits) {
  EXPECT_THAT(bench.ask("*IDN?"), StartsWith("Siglent Technologies,SDG2042X,"));
  EXPECT_EQ(bench.ask("C1:OUTP?"), "C1:OUTP OFF,LOAD,HZ,PLRT,NOR");
  EXPECT_EQ(bench.ask("C1:BSWV?"),
            "C1:BSWV WVTP,SINE,FRQ,1000HZ,PERI,0.001S,AMP,4V,AMPVRMS,1.41421Vrms,OFST,0V,HLEV,2V,"
            "LLEV,-2V,PHSE,0");
  EXPECT_EQ(bench.ask("MODE?"), "MODE PHASE-LOCKED");
}

TEST_F(SiglentGenerator, ReadsShortAndLongFormsInAnyCase) {
  bench.say({"c1:basic_wave frq,1khz,amp,500mV", "C1:BSWV OFST,0.5V"});
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 1000);
  EXPECT_NEAR(bench.settings().amplitude_vpp, 0.5, 1e-12);
  EXPECT_NEAR(bench.settings().offset_v, 0.5, 1e-12);
  bench.say({"C1:OUTPUT ON"});
  EXPECT_TRUE(bench.generator->output_is_on());
}

TEST_F(SiglentGenerator, LeavesUnknownQueriesUnansweredAndAnswersTheNextOne) {
  bench.client->say("CURRPRT?");
  bench.client->say("SYST:ERR?");
  bench.client->say("WVDT? USER,none");
  EXPECT_EQ(bench.ask("*OPC?"), "1");
}

TEST_F(SiglentGenerator, ReadsBackAWaveformWithAnyByteButNewline) {
  Codes codes(1000);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] = static_cast<std::int16_t>(static_cast<int>(i) * 64 - 32000);
    if ((codes[i] & 0xff) == 0x0a || ((codes[i] >> 8) & 0xff) == 0x0a) {
      codes[i] = 0x3b23;  // "#;" as bytes
    }
  }
  upload("wave", codes);
  bench.client->say("WVDT? USER,wave");
  const std::string header =
      "WVDT WVNM,wave,LENGTH,2000B,TYPE,5,FREQ,1000.000000000,AMPL,4.000000,OFST,0.000000,"
      "PHASE,0.000000000,WAVEDATA,";
  EXPECT_EQ(bench.client->bytes(header.size()), header);
  EXPECT_EQ(bench.client->bytes(2000), bytes_of(codes));
  EXPECT_EQ(bench.client->bytes(1), "\n");
  EXPECT_EQ(bench.ask("STL? USER"), "STL WVNM,wave");
}

TEST_F(SiglentGenerator, StoresWhatCameBeforeANewlineInTheBytes) {
  Codes codes(100, 0x1111);
  codes[20] = 0x220a;
  upload("cut", codes);
  // The rest of the bytes is a message of its own, with this command at its end.
  bench.client->say("");
  bench.say({});
  EXPECT_THAT(bench.generator->waveform("cut"), Optional(Codes(20, 0x1111)));
}

TEST_F(SiglentGenerator, DropsTheByteThatIsHalfAPoint) {
  Codes codes(100, 0x1111);
  codes[20] = 0x0a22;
  upload("cut", codes);
  bench.say({});
  EXPECT_THAT(bench.generator->waveform("cut"), Optional(Codes(20, 0x1111)));
}

TEST_F(SiglentGenerator, LosesTheMessageAfterWvtpBesideOtherFields) {
  bench.client->say("C1:BSWV WVTP,SQUARE,FRQ,50");
  bench.client->say("C1:OUTP ON");
  bench.say({});
  EXPECT_EQ(bench.settings().function, GeneratorFunction::kSquare);
  EXPECT_FALSE(bench.generator->output_is_on());
  bench.say({"C1:BSWV WVTP,SINE", "C1:OUTP ON"});
  EXPECT_TRUE(bench.generator->output_is_on());
}

TEST_F(SiglentGenerator, ClampsInSilence) {
  bench.say({"C1:BSWV AMP,0.001", "C1:BSWV FRQ,1e9"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, 0.002, 1e-12);
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 40e6);
  bench.say({"C1:BSWV AMP,30", "C1:BSWV OFST,1"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, 20, 1e-12);
  EXPECT_NEAR(bench.settings().offset_v, 0, 1e-12);
  bench.say({"C1:BSWV AMP,1.23456"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, 1.235, 1e-12);
}

// The voltage at the output stays; what is displayed is that into the load.
TEST_F(SiglentGenerator, ShowsHalfTheAmplitudeWhenSetForFiftyOhms) {
  bench.say({"C1:BSWV AMP,4", "C1:OUTP LOAD,50"});
  EXPECT_NEAR(bench.settings().amplitude_vpp, 2, 1e-12);
  bench.say({"C1:BSWV AMP,4", "C1:OUTP ON", "C1:BSWV FRQ,50"});
  const std::vector<double> volts = bench.output(1280);  // one cycle
  EXPECT_NEAR(*std::max_element(volts.begin(), volts.end()), 4.0, 1e-3);
}

TEST_F(SiglentGenerator, PlaysPointsAtASampleRateInTrueArbOnly) {
  upload("ramp", {0, 8000, 16000, 24000, 24000, 16000, 8000, 0, 0, 0});
  play("ramp");
  bench.say({"C1:SRATE VALUE,6400"});  // not in DDS mode
  EXPECT_DOUBLE_EQ(bench.settings().sample_rate_hz, 1e6);
  bench.say({"C1:SRATE MODE,TARB,VALUE,6400,INTER,LINE", "C1:OUTP ON"});
  EXPECT_EQ(bench.ask("C1:SRATE?"), "C1:SRATE MODE,TARB,INTER,LINE,VALUE,6400Sa/s");
  EXPECT_EQ(bench.settings().between, Between::kLine);
  EXPECT_THAT(bench.ask("C1:BSWV?"), StartsWith("C1:BSWV WVTP,ARB,FRQ,640HZ,"));
  // Ten steps a point. Half the amplitude is 2 V, of 32 767 codes.
  bench.output(100 - static_cast<std::size_t>(bench.step % 100));
  const std::vector<double> line = bench.output(100);
  EXPECT_NEAR(line[5], 2.0 * 8000 * 0.55 / 32767, 1e-6);
  bench.say({"C1:SRATE INTER,HOLD"});
  bench.output(100);
  const std::vector<double> held = bench.output(100);
  EXPECT_NEAR(held[5], 0.0, 1e-6);
  EXPECT_NEAR(held[15], 2.0 * 8000 / 32767, 1e-6);
}

// Waveforms of another length than the table of 16 384 are played with repeated or missing points.
TEST_F(SmallSiglentGenerator, RepeatsPointsAtAFrequency) {
  EXPECT_THAT(bench.ask("*IDN?"), StartsWith("Siglent Technologies,SDG1032X,"));
  Codes codes(12000);
  for (std::size_t i = 0; i < codes.size(); ++i) {
    codes[i] = i % 2 == 0 ? std::int16_t{16384} : std::int16_t{-16384};
  }
  codes[0] = 0;
  for (auto& code : codes) {
    code = static_cast<std::int16_t>(code & ~0xff);  // no 0x0A
  }
  upload("teeth", codes);
  play("teeth");
  // One entry of the table takes a step.
  bench.say({"C1:BSWV FRQ,3.90625", "C1:BSWV AMP,4", "C1:OUTP ON"});
  const std::vector<double> volts = bench.output(16384);
  std::size_t repeated = 0;
  for (std::size_t i = 1; i < volts.size(); ++i) {
    repeated += std::abs(volts[i] - volts[i - 1]) < 1e-4 ? 1 : 0;
  }
  EXPECT_EQ(repeated, 16384U - 12000U);
}

TEST_F(SmallSiglentGenerator, HasNoTrueArbAndKeeps16384Points) {
  bench.say({"C1:SRATE MODE,TARB,VALUE,1000"});
  EXPECT_EQ(bench.settings().point_rate, PointRate::kFrequency);
  upload("most", Codes(16384, 0x1100));
  upload("more", Codes(16385, 0x1100));
  bench.say({});
  EXPECT_TRUE(bench.generator->waveform("most"));
  EXPECT_FALSE(bench.generator->waveform("more"));
}

// 14 of the 16 bits reach the DAC.
TEST_F(SmallSiglentGenerator, DropsTheLowestTwoBits) {
  upload("step", Codes(16384, 0x1203));
  play("step");
  bench.say({"C1:BSWV AMP,4", "C1:OUTP ON"});
  EXPECT_NEAR(bench.mean(100), 2.0 * 0x1200 / 32767, 1e-6);
  EXPECT_THAT(bench.generator->waveform("step"), Optional(Codes(16384, 0x1203)));
}

TEST_F(SiglentGenerator, TakesBurstFieldsOnlyWhileTheBurstIsOn) {
  bench.say({"C1:BTWV TRSR,MAN,TIME,3"});
  EXPECT_EQ(bench.ask("C1:BTWV?"), "C1:BTWV STATE,OFF");
  bench.say({"C1:BTWV STATE,ON"});
  EXPECT_THAT(bench.ask("C1:BTWV?"),
              StartsWith("C1:BTWV STATE,ON,PRD,0.01S,STPS,0,TRSR,INT,TRMD,OFF,TIME,1,"));
  bench.say({"C1:BTWV TRSR,MAN,TIME,3"});
  EXPECT_EQ(bench.ask("C1:BTWV?"),
            "C1:BTWV STATE,ON,STPS,0,TRSR,MAN,TRMD,OFF,TIME,3,DLAY,6.04035e-07S,GATE_NCYC,NCYC,"
            "CARR,WVTP,SINE,FRQ,1000HZ,AMP,4V,AMPVRMS,1.41421Vrms,OFST,0V,PHSE,0");
  bench.say({"C1:BTWV TIME,INF"});
  EXPECT_EQ(bench.settings().trigger, TriggerSource::kExternal);
  bench.say({"C1:BSWV WVTP,RAMP"});
  EXPECT_FALSE(bench.settings().burst_on);
}

TEST_F(SiglentGenerator, PlaysABurstOnceAfterAManualTrigger) {
  upload("hill", {0, 16000, 32000, 16000, 0, 0, 0, 0});
  play("hill");
  bench.say({"C1:SRATE MODE,TARB,VALUE,640", "C1:BTWV STATE,ON", "C1:BTWV TRSR,MAN",
             "C1:BTWV TIME,1", "C1:OUTP ON"});
  EXPECT_NEAR(bench.mean(2000), 0.0, 1e-9);
  bench.say({"C1:BTWV MTRIG"});
  const std::vector<double> volts = bench.output(2000);
  EXPECT_NEAR(volts[250], 2.0 * 32000 / 32767, 1e-6);
  EXPECT_NEAR(std::accumulate(volts.begin() + 800, volts.end(), 0.0), 0.0, 1e-9);
}

TEST_F(SiglentGenerator, KeepsItsOldWaveformWhenMemoryIsFull) {
  upload("kept", Codes(100, 0x1100));
  bench.say({});
  GeneratorFaults faults;
  faults.memory_full = true;
  bench.generator->set_faults(faults);
  upload("kept", Codes(100, 0x2200));
  upload("other", Codes(100, 0x2200));
  bench.say({});
  EXPECT_THAT(bench.generator->waveform("kept"), Optional(Codes(100, 0x1100)));
  EXPECT_FALSE(bench.generator->waveform("other"));
}

TEST_F(SiglentGenerator, KeepsWaveformsWithoutPower) {
  upload("kept", Codes(100, 0x1100));
  bench.say({});
  bench.generator->reset_now(std::chrono::milliseconds(1));
  EXPECT_TRUE(bench.generator->waveform("kept"));
}

TEST_F(SiglentGenerator, IgnoresTheSelectionOfAnUnknownWaveform) {
  upload("known", Codes(100, 0x1100));
  bench.say({"C1:ARWV NAME,known", "C1:ARWV NAME,unknown"});
  EXPECT_EQ(bench.ask("C1:ARWV?"), "C1:ARWV INDEX,0,NAME,known");
}

TEST_F(SiglentGenerator, IgnoresTheSecondChannel) {
  bench.say({"C2:OUTP ON", "C2:BSWV FRQ,50"});
  EXPECT_FALSE(bench.generator->output_is_on());
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 1000);
}

TEST_F(SiglentGenerator, LogsMessagesWithoutTheBytesOfWaveforms) {
  upload("wave", Codes(10, 0x1100));
  bench.say({"C1:OUTP ON"});
  EXPECT_THAT(bench.generator->messages(),
              ElementsAre("C1:WVDT WVNM,wave,LENGTH,20B,WAVEDATA,", "C1:OUTP ON", "*OPC?"));
}

}  // namespace
}  // namespace gsbench::test
