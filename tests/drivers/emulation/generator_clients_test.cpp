// Client programs of others set the emulated generators: PyMeasure's driver of the Agilent 33500
// over PyVISA-py, and lxi-tools.
#include "generator_bench.hpp"
#include <test_support/output_of.hpp>

#include <gmock/gmock.h>

namespace gsbench::test {
namespace {

using emulation::Between;
using emulation::Generator;
using emulation::GeneratorFunction;
using emulation::GeneratorModel;
using emulation::GeneratorOptions;
using emulation::TriggerSource;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kIdentity = "Agilent Technologies,33522B,MY52800001,4.00-1.19-2.00-58-00\n";

std::string number_of_port(const Generator& generator) {
  const std::string port = generator.port();
  return port.substr(port.rfind(':') + 1);
}

// What the script prints after the identity.
std::string pymeasure(const Generator& generator, const std::string& step) {
  const Output output = output_of("/usr/bin/python3 " GSBENCH_SOURCE_DIR
                                  "/tests/drivers/emulation/generator_pymeasure.py " +
                                  number_of_port(generator) + " " + step);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_THAT(output.text, StartsWith(kIdentity));
  return output.text.substr(std::min(output.text.size(), std::string(kIdentity).size()));
}

std::string lxi(const Generator& generator, const std::string& command) {
  const Output output = output_of("lxi scpi --address 127.0.0.1 --port " +
                                  number_of_port(generator) + " --raw '" + command + "'");
  EXPECT_EQ(output.exit_code, 0) << command;
  return output.text;
}

double amplitude_v(const std::vector<double>& volts) {
  const auto [low, high] = std::minmax_element(volts.begin(), volts.end());
  return (*high - *low) / 2;
}

TEST(PyMeasure, PlaysASineOnTheKeysight) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.client.reset();
  EXPECT_EQ(pymeasure(*bench.generator, "sine"), "SIN 50.0 2.5 0.25 ON\n");
  EXPECT_DOUBLE_EQ(bench.settings().frequency_hz, 50);
  EXPECT_DOUBLE_EQ(bench.settings().amplitude_vpp, 2.5);
  EXPECT_TRUE(std::isinf(bench.settings().load_ohm));
  EXPECT_TRUE(bench.generator->output_is_on());
  const std::vector<double> volts = bench.output(1280);  // a cycle
  EXPECT_NEAR(amplitude_v(volts), 1.25, 1e-4);
  EXPECT_NEAR(std::accumulate(volts.begin(), volts.end(), 0.0) / 1280, 0.25, 1e-6);
}

TEST(PyMeasure, TriggersABurstOfTheKeysightAndWaitsForItsEnd) {
  GeneratorOptions options;
  options.model = GeneratorModel::k33522b;
  const auto generator = Generator::start(options).take();
  EXPECT_EQ(pymeasure(*generator, "burst"), "TRIG 3.0 BUS True\ntriggered\n");
  EXPECT_DOUBLE_EQ(generator->settings().burst_cycles, 3);
  EXPECT_EQ(generator->settings().trigger, TriggerSource::kManual);
  EXPECT_TRUE(generator->settings().burst_on);
  EXPECT_FALSE(generator->is_playing());
}

TEST(PyMeasure, UploadsAWaveformToTheKeysight) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.say({"OUTP:LOAD INF", "VOLT 4", "OUTP ON"});
  bench.client.reset();
  EXPECT_THAT(pymeasure(*bench.generator, "arbitrary"), EndsWith("ARB \"ramp\" 8000.0 OFF\n"));
  const auto stored = bench.generator->waveform("ramp");
  ASSERT_TRUE(stored);
  ASSERT_EQ(stored->size(), 1000U);
  EXPECT_EQ(stored->front(), -10000);
  EXPECT_EQ(stored->back(), 9980);
  EXPECT_EQ(bench.settings().between, Between::kHold);
  // 1000 points at 8 kSa/s are 8000 steps.
  const std::vector<double> volts = bench.output(8000);
  EXPECT_NEAR(amplitude_v(volts), 2.0 * 9990 / 32767, 1e-6);
}

TEST(PyMeasure, ReadsTheErrorsOfTheKeysight) {
  GeneratorBench bench(GeneratorModel::k33522b);
  bench.client.reset();
  EXPECT_THAT(pymeasure(*bench.generator, "unhappy"),
              HasSubstr("Specified arb waveform does not exist"));
}

TEST(LxiTools, SetAndReadTheSiglent) {
  for (const auto model : {GeneratorModel::kSdg1032x, GeneratorModel::kSdg2042x}) {
    GeneratorBench bench(model);
    bench.client.reset();
    EXPECT_THAT(lxi(*bench.generator, "*IDN?"), StartsWith("Siglent Technologies,SDG"));
    lxi(*bench.generator, "C1:BSWV FRQ,50HZ,AMP,2V,OFST,0.5V");
    lxi(*bench.generator, "C1:OUTP ON");
    EXPECT_EQ(lxi(*bench.generator, "C1:BSWV?"),
              "C1:BSWV WVTP,SINE,FRQ,50HZ,PERI,0.02S,AMP,2V,AMPVRMS,0.707107Vrms,OFST,0.5V,"
              "HLEV,1.5V,LLEV,-0.5V,PHSE,0\n");
    EXPECT_EQ(lxi(*bench.generator, "C1:OUTP?"), "C1:OUTP ON,LOAD,HZ,PLRT,NOR\n");
    EXPECT_NEAR(amplitude_v(bench.output(1280)), 1.0, 1e-4);
  }
}

TEST(LxiTools, SetAndReadTheRigol) {
  GeneratorBench bench(GeneratorModel::kDg1062z);
  bench.client.reset();
  EXPECT_THAT(lxi(*bench.generator, "*IDN?"), StartsWith("Rigol Technologies,DG1062Z,"));
  lxi(*bench.generator, ":OUTP1:LOAD INF;:SOUR1:APPL:SIN 50,2,0.5;:OUTP1 ON");
  EXPECT_EQ(lxi(*bench.generator, ":SOUR1:FREQ?"), "5.000000E+01\n");
  EXPECT_EQ(lxi(*bench.generator, ":OUTP1?"), "ON\n");
  EXPECT_NEAR(amplitude_v(bench.output(1280)), 1.0, 1e-4);
  lxi(*bench.generator, ":SOUR1:DATA VOLATILE,-1,-0.5,0,0.5,1,0.5,0,-0.5");
  EXPECT_EQ(lxi(*bench.generator, ":SOUR1:FUNC?"), "USER\n");
  EXPECT_EQ(lxi(*bench.generator, ":SOUR1:DATA:POIN? VOLATILE"), "8\n");
  EXPECT_EQ(bench.settings().function, GeneratorFunction::kArbitrary);
  lxi(*bench.generator, ":SOUR1:FREQ high");
  EXPECT_THAT(lxi(*bench.generator, ":SYST:ERR?"), StartsWith("-104,"));
}

}  // namespace
}  // namespace gsbench::test
