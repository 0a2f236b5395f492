// The models. Figures of the data sheets, identities as the instruments answer them; serial numbers
// are made up.
#include "generator_state.hpp"

namespace gsbench::emulation {

namespace {

constexpr double kOpen_ohm = std::numeric_limits<double>::infinity();

GeneratorSettings defaults_of(double amplitude_vpp, double load_ohm, PointRate point_rate,
                              double sample_rate_hz) {
  GeneratorSettings settings;
  settings.amplitude_vpp = amplitude_vpp;
  settings.load_ohm = load_ohm;
  settings.point_rate = point_rate;
  settings.sample_rate_hz = sample_rate_hz;
  return settings;
}

}  // namespace

const GeneratorFacts& facts_of(GeneratorModel model) {
  // Siglent: 4 V into high impedance by default (answers of instruments to BSWV?, as drivers quote
  // them). Waveforms are files in non-volatile memory. Without TrueArb, a table of 16 384 points is
  // read at a fixed clock; the data sheets do not say how a waveform of another length is fitted,
  // here by taking the nearest point below.
  static const GeneratorFacts sdg1032x = {
      "Siglent Technologies,SDG1032X,SDG1XEMU000001,1.01.01.33R1B6",
      2,
      2,
      16384,
      1 << 20,
      16384,
      0.0,
      30e6,
      6e6,
      true,
      defaults_of(4.0, kOpen_ohm, PointRate::kFrequency, 1e6)};
  static const GeneratorFacts sdg2042x = {
      "Siglent Technologies,SDG2042X,SDG2XEMU000001,2.01.01.23R7",
      0,
      8,
      8'000'000,
      16'000'000,
      16384,
      75e6,
      40e6,
      20e6,
      true,
      defaults_of(4.0, kOpen_ohm, PointRate::kFrequency, 1e6)};
  // Rigol: 5 V into 50 Ω (DG1000Z Programming Guide, OUTPut:LOAD: default 50 Ω). 8 M points.
  static const GeneratorFacts dg1062z = {"Rigol Technologies,DG1062Z,DG1ZEMU000001,03.01.12",
                                         0,
                                         8,
                                         8'388'608,
                                         8'388'608,
                                         0,
                                         60e6,
                                         60e6,
                                         20e6,
                                         false,
                                         defaults_of(5.0, 50.0, PointRate::kFrequency, 20e6)};
  // Keysight: 100 mV into 50 Ω, 40 kSa/s (33500 Series Operating and Service Guide, *RST).
  static const GeneratorFacts k33522b = {
      "Agilent Technologies,33522B,MY52800001,4.00-1.19-2.00-58-00",
      0,
      8,
      1'000'000,
      1'000'000,
      0,
      250e6,
      30e6,
      30e6,
      false,
      defaults_of(0.1, 50.0, PointRate::kSampleRate, 40e3)};
  switch (model) {
    case GeneratorModel::kSdg1032x:
      return sdg1032x;
    case GeneratorModel::kSdg2042x:
      return sdg2042x;
    case GeneratorModel::kDg1062z:
      return dg1062z;
    case GeneratorModel::k33522b:
      break;
  }
  return k33522b;
}

}  // namespace gsbench::emulation
