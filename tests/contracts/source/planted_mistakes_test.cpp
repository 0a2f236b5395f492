// A mistake in the description of an instrument, one for each quirk, is found: prepare() or the run
// fails, or the stored waveform is not the planned one.
#include "generator_rig.hpp"
#include <test_support/mains.hpp>

#include <algorithm>

#include <gmock/gmock.h>

#include <station/instrument_file.hpp>

namespace gsbench::test {
namespace {

using scpi::Instrument;
using testing::HasSubstr;

constexpr std::size_t kSdg1032x = 0;
constexpr std::size_t kSdg2042x = 1;
constexpr std::size_t kDg1062z = 2;
constexpr std::size_t k33522b = 3;

scpi::Setting& setting(Instrument& instrument, const std::string& name) {
  return *std::find_if(instrument.settings.begin(), instrument.settings.end(),
                       [&](const scpi::Setting& one) { return one.name == name; });
}

// What follows is set before what precedes.
void move_behind(Instrument& instrument, const std::string& moved, const std::string& last) {
  auto& all = instrument.settings;
  const auto at = [&](const std::string& name) {
    return std::find_if(all.begin(), all.end(),
                        [&](const scpi::Setting& one) { return one.name == name; });
  };
  scpi::Setting taken = *at(moved);
  all.erase(at(moved));
  taken.when = scpi::When::kAfterUpload;
  all.insert(at(last) + 1, taken);
}

struct Mistake {
  const char* name;
  std::size_t model;
  void (*plant)(Instrument&);
  const char* found;  // in the error
};

const Mistake kMistakes[] = {
    {"NewlinesInTheWaveform", kSdg2042x, [](Instrument& of) { of.quirks.clear(); },
     "not stored as sent: 238 bytes instead of 31682"},
    {"NewlinesInTheWaveformOfASmallOne", kSdg1032x,
     [](Instrument& of) { of.quirks = {scpi::Quirk::kFixedLength}; },
     "not stored as sent: 772 bytes instead of 32768"},
    {"QueryThatIsUnknownToASiglent", kSdg2042x,
     [](Instrument& of) { setting(of, "burst").asked.query = "C1:BURST?"; },
     "no answer to \"C1:BURST?\" within 0.3 s; it does not answer what it does not know"},
    {"FunctionBesideOtherFields", kSdg2042x,
     [](Instrument& of) { setting(of, "function").commands = {"C1:BSWV WVTP,ARB,FRQ,1000"}; },
     "playing point by point is DDS, but TARB was set"},
    {"BurstSetBeforeItIsOn", kSdg2042x,
     [](Instrument& of) { move_behind(of, "burst", "burst cycles"); },
     "burst trigger is INT, but MAN was set"},
    {"AmplitudeForAnotherLoad", kSdg2042x,
     [](Instrument& of) { setting(of, "load").commands = {"C1:OUTP LOAD,50"}; },
     "load is 50, but HZ was set"},
    {"LoadNotSet", k33522b, [](Instrument& of) { setting(of, "load").commands.clear(); },
     "load is +5.000000000000000E+01, but 9.9E37 was set"},
    {"AmplitudeBeforeLoad", k33522b, [](Instrument& of) { move_behind(of, "load", "amplitude"); },
     "amplitude is +1.302000000000000E+01, but 6.51 was set"},
    {"AmplitudeBeforeLoadOfARigol", kDg1062z,
     [](Instrument& of) { move_behind(of, "load", "amplitude"); },
     "amplitude is 1.301200E+01, but 6.506 was set"},
    {"PolarityNotSet", kSdg2042x,
     [](Instrument& of) { setting(of, "polarity").commands = {"C1:OUTP PLRT,INVT"}; },
     "polarity is INVT, but NOR was set"},
    {"WaveformNotSelected", kSdg2042x,
     [](Instrument& of) { setting(of, "waveform").commands.clear(); },
     "waveform is StairUp, but gsbench was set"},
    {"PlayedByDds", kSdg2042x,
     [](Instrument& of) { setting(of, "playing point by point").commands = {"C1:SRATE MODE,DDS"}; },
     "playing point by point is DDS, but TARB was set"},
    {"WrongBlockFormOfASiglent", kSdg2042x,
     [](Instrument& of) { of.format.block = scpi::Block::kBlock; },
     "not stored as sent: byte 0 is 0x23 instead of 0x00"},
    {"ByteOrderNotSet", k33522b, [](Instrument& of) { setting(of, "byte order").commands.clear(); },
     "byte order is NORM, but SWAP was set"},
    {"MemoryNotCleared", k33522b,
     [](Instrument& of) {
       of.dialect.clear.clear();
       of.dialect.reset = {"*CLS"};
     },
     "reports an error after the upload: +786,"},
    {"WrongBlockFormOfAKeysight", k33522b,
     [](Instrument& of) { of.format.block = scpi::Block::kRaw; },
     "reports an error after the upload: -104,"},
    {"FilterNotSwitchedOff", k33522b,
     [](Instrument& of) { setting(of, "filter").commands.clear(); },
     "filter is STEP, but OFF was set"},
    {"PacketsTooLarge", kDg1062z, [](Instrument& of) { of.memory.packet_points = 16384; },
     "reports an error after the upload: -223,"},
    {"PacketsTooFast", kDg1062z, [](Instrument& of) { of.timing.packet_s = 0.0; },
     "but 15841 was set"},
    {"EveryPacketTheLast", kDg1062z, [](Instrument& of) { of.dialect.more_part = "END"; },
     "number of points is 7649, but 15841 was set"},
    {"NoPacketTheLast", kDg1062z, [](Instrument& of) { of.dialect.last_part = "CON"; },
     "number of points is 8, but 15841 was set"},
    {"WrongByteOrderOfPackets", kDg1062z,
     [](Instrument& of) { of.format.byte_order = scpi::ByteOrder::kBig; },
     "reports an error after the upload: -222,"},
    {"SignedCodesOfARigol", kDg1062z,
     [](Instrument& of) { of.format.codes = scpi::Codes::kSigned; },
     "reports an error after the upload: -222,"},
    {"BurstBeforeTheUpload", kDg1062z,
     [](Instrument& of) { setting(of, "burst").when = scpi::When::kBeforeUpload; },
     "burst is OFF, but ON|1 was set"},
    {"UploadSwitchesTheOutputOn", kDg1062z, [](Instrument& of) { of.quirks.clear(); },
     "the output is on, but off was set"},
    {"OlderSyntax", kDg1062z,
     [](Instrument& of) { of.dialect.upload = ":SOUR1:DATA:DAC VOLATILE,{part},"; },
     "reports an error after the upload: -220,"},
    {"IdleAtTheTop", kDg1062z,
     [](Instrument& of) {
       setting(of, "level between bursts").commands = {":SOUR1:BURS:IDLE TOP"};
     },
     "level between bursts is TOP, but FPT was set"},
};

class PlantedMistake : public testing::TestWithParam<Mistake> {};

INSTANTIATE_TEST_SUITE_P(In, PlantedMistake, testing::ValuesIn(kMistakes),
                         [](const auto& of) { return std::string(of.param.name); });

TEST_P(PlantedMistake, IsFound) {
  Mains mains;
  mains.duration_s = 0.3;
  GeneratorRig rig(kGeneratorCases[GetParam().model]);
  // A waveform of this name is there already, as after a run.
  ASSERT_TRUE(rig.make_source()->prepare(mains).ok());
  // The load that a new instrument is set for.
  emulation::PanelChange load;
  load.load_ohm = 50.0;
  rig.generator().press(load);
  emulation::GeneratorFaults faults;
  faults.upload_switches_on = GetParam().model == kDg1062z;
  rig.generator().set_faults(faults);
  Instrument altered = rig.instrument;
  GetParam().plant(altered);
  const auto source = rig.make_source(altered);
  const auto prepared = source->prepare(mains);
  ASSERT_FALSE(prepared.ok());
  EXPECT_THAT(prepared.error(), HasSubstr(GetParam().found));
  EXPECT_TRUE(source->make_safe().ok());
  EXPECT_FALSE(rig.output_is_on());
}

// Played at a frequency, a waveform that does not fill the memory would be stretched.
TEST(PlantedMistakes, OfALengthThatIsNotFixedAreFoundInTheDescription) {
  Instrument altered = station::load_instrument("siglent-sdg1000x");
  EXPECT_TRUE(scpi::check(altered).ok());
  altered.quirks = {scpi::Quirk::kAvoidNewline, scpi::Quirk::kSilentIfUnknown};
  const auto checked = scpi::check(altered);
  ASSERT_FALSE(checked.ok());
  EXPECT_THAT(checked.error(),
              HasSubstr("the frequency of the whole memory needs waveforms of a fixed length"));
}

// The same circumstances, without a mistake.
TEST(PlantedMistakes, AreNotFoundWhereThereAreNone) {
  Mains mains;
  mains.duration_s = 0.3;
  for (const GeneratorCase& of : kGeneratorCases) {
    GeneratorRig rig(of);
    emulation::GeneratorFaults faults;
    faults.upload_switches_on = of.model == emulation::GeneratorModel::kDg1062z;
    rig.generator().set_faults(faults);
    const auto source = rig.make_source();
    for (int run = 0; run < 2; ++run) {
      const auto prepared = source->prepare(mains);
      EXPECT_TRUE(prepared.ok()) << of.name << ": " << prepared.error();
      EXPECT_FALSE(rig.output_is_on()) << of.name;
      EXPECT_TRUE(source->make_safe().ok());
    }
  }
}

// Verification and comparison are themselves checked: without them, a mistake goes through.
TEST(PlantedMistakes, AreNotFoundWithoutReadingBack) {
  Mains mains;
  mains.duration_s = 0.3;
  GeneratorRig rig(kGeneratorCases[kSdg2042x]);
  Instrument altered = rig.instrument;
  altered.quirks.clear();
  altered.verification = scpi::Verification::kNone;
  const auto source = rig.make_source(altered);
  const auto prepared = source->prepare(mains);
  EXPECT_TRUE(prepared.ok()) << prepared.error();
  const auto stored = rig.generator().waveform("gsbench");
  const auto plan = scpi::make_plan(mains, altered, rig.options.plan);
  ASSERT_TRUE(plan.ok());
  EXPECT_TRUE(!stored || stored->size() < plan.value().codes.size());
}

TEST(PlantedMistakes, AreNotFoundWithoutAskingBack) {
  Mains mains;
  mains.duration_s = 0.3;
  GeneratorRig rig(kGeneratorCases[kSdg2042x]);
  Instrument altered = rig.instrument;
  setting(altered, "amplitude").tolerance = 100.0;
  emulation::GeneratorFaults faults;
  faults.silent_limit_vpp = 5.0;
  rig.generator().set_faults(faults);
  EXPECT_TRUE(rig.make_source(altered)->prepare(mains).ok());
  EXPECT_EQ(rig.generator().settings().amplitude_vpp, 5.0);
}

}  // namespace
}  // namespace gsbench::test
