#include "generator_rig.hpp"

#include <test_support/demand.hpp>

#include <algorithm>
#include <stdexcept>

#include <station/instrument_file.hpp>

namespace gsbench::test {

using emulation::GeneratorModel;

const GeneratorCase kGeneratorCases[4] = {
    {"Sdg1032x", "siglent-sdg1000x", GeneratorModel::kSdg1032x},
    {"Sdg2042x", "siglent-sdg2000x", GeneratorModel::kSdg2042x},
    {"Dg1062z", "rigol-dg1000z", GeneratorModel::kDg1062z},
    {"K33522b", "keysight-33500b", GeneratorModel::k33522b}};

scpi::Instrument quick_instrument(const GeneratorCase& of) {
  scpi::Instrument instrument = station::load_instrument(of.instrument);
  // Packets that come faster are lost.
  instrument.timing = {0.0, instrument.timing.packet_s, 0.0, 0.0, 0.0};
  instrument.timing.answer_s = 0.3;
  return instrument;
}

GeneratorRig::GeneratorRig(const GeneratorCase& of, double clock_ppm)
    : instrument(quick_instrument(of)) {
  emulation::GeneratorOptions emulated;
  emulated.model = of.model;
  emulated.clock_ppm = clock_ppm;
  auto started = emulation::Generator::start(emulated);
  if (!started.ok()) {
    throw std::runtime_error(started.error());
  }
  generator_ = started.take();
  options.port = generator_->port();
  options.plan.boot_s = 0.0;
  options.plan.tolerances.voltage_pu = 0.1;  // 16 384 points
  options.make_safe_s = 1.0;
}

std::unique_ptr<source::Source> GeneratorRig::make_source() const {
  return make_source(instrument);
}

std::unique_ptr<source::Source> GeneratorRig::make_source(const scpi::Instrument& altered) const {
  return scpi::make_scpi_source(altered, options);
}

std::string first_error_of_run(source::Source& source, const source::Stimulus& stimulus) {
  if (const auto prepared = source.prepare(stimulus); !prepared.ok()) {
    return prepared.error();
  }
  for (const auto call :
       {&source::Source::energise, &source::Source::hold, &source::Source::start}) {
    if (const drivers::Status done = (source.*call)(); !done.ok()) {
      return done.error();
    }
  }
  for (std::int64_t tick = 0; tick < stimulus.total_ticks();) {
    const auto played = source.advance(std::min(tick + 800, stimulus.total_ticks()));
    if (!played.ok()) {
      return played.error();
    }
    tick = played.value();
  }
  const drivers::Status stopped = source.stop();
  return stopped.ok() ? "" : stopped.error();
}

}  // namespace gsbench::test
