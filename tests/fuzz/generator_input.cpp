#include "generator_input.hpp"

#include "generator_dialect.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <string_view>

namespace gsbench::fuzz {
namespace {

using emulation::GeneratorDialect;
using emulation::GeneratorModel;
using emulation::GeneratorOptions;
using emulation::GeneratorReply;
using emulation::GeneratorSettings;
using emulation::GeneratorState;

constexpr std::array kModels = {GeneratorModel::kSdg1032x, GeneratorModel::kSdg2042x,
                                GeneratorModel::kDg1062z, GeneratorModel::k33522b};

struct Instrument {
  explicit Instrument(GeneratorModel model)
      : state(options_of(model)),
        dialect(model == GeneratorModel::k33522b    ? make_keysight(state)
                : model == GeneratorModel::kDg1062z ? make_rigol(state)
                                                    : make_siglent(state, model == kModels[1])) {
    state.player().render(0, 0, nullptr);
  }

  // Until then, commands take effect at the end of what is rendered.
  static GeneratorOptions options_of(GeneratorModel model) {
    GeneratorOptions options;
    options.model = model;
    options.time.start = std::chrono::steady_clock::now() + std::chrono::hours(1);
    return options;
  }

  std::string answers_to(std::string_view bytes) {
    std::string answers;
    while (const std::size_t length = dialect->message_size(bytes)) {
      static_cast<void>(dialect->text_size(bytes.substr(0, length)));
      answers += dialect->execute(bytes.substr(0, length)).bytes;
      bytes.remove_prefix(length);
    }
    if (dialect->in_block()) {
      dialect->give_up_block();
    }
    dialect->connect();
    return answers;
  }

  GeneratorState state;
  std::unique_ptr<GeneratorDialect> dialect;
};

std::string wrong_with_settings_of(const GeneratorState& state) {
  const GeneratorSettings& now = state.settings();
  for (const double value :
       {now.frequency_hz, now.amplitude_vpp, now.offset_v, now.phase_deg, now.duty_pct,
        now.symmetry_pct, now.sample_rate_hz, now.burst_period_s}) {
    if (!std::isfinite(value)) {
      return "a setting is not finite";
    }
  }
  const double peak = std::abs(now.offset_v) + now.amplitude_vpp / 2;
  if (now.amplitude_vpp < 0 || peak > state.highest_peak_v() * 1.0001 + state.lowest_vpp()) {
    return "a voltage is beyond the limit";
  }
  if (now.frequency_hz <= 0 || now.sample_rate_hz <= 0 || now.burst_cycles < 1 ||
      now.load_ohm < 1 || now.burst_period_s <= 0) {
    return "a setting is too low";
  }
  return "";
}

std::string wrong_with_output_of(GeneratorState& state) {
  std::array<float, 64> volts{};
  state.player().render(0, volts.size(), volts.data());
  for (const float volt : volts) {
    if (!(std::abs(volt) <= 10.1F) || (!state.settings().output_on && volt != 0.0F)) {
      return "the output is beyond the limit";
    }
  }
  return "";
}

}  // namespace

std::string wrong_with_generator(const std::uint8_t* bytes, std::size_t size) {
  if (size == 0) {
    return "";
  }
  Instrument instrument(kModels[bytes[0] % kModels.size()]);
  const std::string_view stream(reinterpret_cast<const char*>(bytes) + 1, size - 1);
  const std::string answers = instrument.answers_to(stream);
  if (!answers.empty() && answers.back() != '\n') {
    return "an answer has no end";
  }
  std::string wrong = wrong_with_settings_of(instrument.state);
  if (wrong.empty()) {
    wrong = wrong_with_output_of(instrument.state);
  }
  if (!wrong.empty()) {
    return wrong;
  }
  // A Siglent may lose one message.
  instrument.answers_to("\n*RST\n*RST\n");
  if (instrument.state.settings().output_on) {
    return "the output is on after a reset";
  }
  return instrument.answers_to("*IDN?\n").empty() ? "no identity" : "";
}

std::vector<std::string> generator_seeds() {
  const std::string siglent =
      "*IDN?\nC1:WVDT WVNM,a,LENGTH,32B,WAVEDATA,0123456789abcdef0123456789abcdef\n"
      "WVDT? USER,a\nC1:ARWV NAME,a\nC1:BSWV WVTP,ARB\nC1:SRATE MODE,TARB,VALUE,6400,INTER,LINE\n"
      "C1:BSWV AMP,4V,OFST,-1,FRQ,50HZ\nC1:OUTP LOAD,50\nC1:BTWV STATE,ON\nC1:BTWV "
      "TRSR,MAN,TIME,2\n"
      "C1:OUTP ON\nC1:BTWV MTRIG\nC1:BSWV?\nC1:BTWV?\nC1:SRATE?\nC1:OUTP?\n";
  const std::string rigol =
      ":OUTP1:LOAD INF;:SOUR1:VOLT 4;VOLT:OFFS -1\n"
      ":SOUR1:DATA:DAC16 VOLATILE,END,#2160123456789:;<=>?\n"
      ":SOUR1:DATA VOLATILE,-1,0.5,1\n:SOUR1:FUNC:ARB:SRAT 6400\n:SOUR1:BURS:NCYC 2\n"
      ":SOUR1:BURS:TRIG:SOUR MAN\n:SOUR1:BURS:IDLE 100\n:SOUR1:BURS ON\n:OUTP1 ON\n*TRG\n"
      ":SOUR1:APPL:SIN 50,2,0,90\n:SOUR1:FUNC?\n:SYST:ERR?\n";
  const std::string keysight =
      "FORM:BORD SWAP;:OUTP:LOAD 75\nDATA:ARB:DAC a, #2160123456789abcdef\n"
      "DATA:ARB b, 0, 0.1, -1, 1, 0, 0, 0, 0\nFUNC:ARB \"a\";ARB:SRAT 6400;FILT OFF\n"
      "VOLT:UNIT VRMS;:VOLT 1;VOLT:LOW -1\nFUNC ARB\nBURS:MODE TRIG;NCYC INF;:TRIG:SOUR BUS\n"
      "BURS:STAT ON\nOUTP ON\n*TRG\nABOR\nAPPL:RAMP 50,2,0.5\nFUNC:RAMP:SYMM 0\nVOLT?\nSYST:ERR?\n"
      "VOLT:UNIT DBM\nOUTP:LOAD INF\n";
  const std::string more = "C1:BSWV WVTP,RAMP\nC1:BSWV SYM,0,PHSE,-90\nC1:OUTP PLRT,INVT\n";
  return {'\0' + siglent + more, '\1' + siglent, '\2' + rigol, '\3' + keysight};
}

}  // namespace gsbench::fuzz
