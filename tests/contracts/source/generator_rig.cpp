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

namespace {

constexpr double kPacketPause_s = 0.02;  // packets that come faster are lost

}  // namespace

scpi::Instrument quick_instrument(const GeneratorCase& of) {
  scpi::Instrument instrument = station::load_instrument(of.instrument);
  instrument.timing = {0.0, instrument.timing.packet_s > 0.0 ? kPacketPause_s + 0.02 : 0.0, 0.0,
                       0.0, 0.0};
  // An emulator is triggered when the message arrives.
  instrument.accuracy.trigger_latency_s = 0.0;
  instrument.memory.points = std::min<std::int64_t>(instrument.memory.points, 20000);
  instrument.timing.answer_s = 0.3;
  return instrument;
}

GeneratorRig::GeneratorRig(const GeneratorCase& of, double clock_ppm)
    : instrument(quick_instrument(of)) {
  emulation::GeneratorOptions emulated;
  emulated.model = of.model;
  emulated.clock_ppm = clock_ppm;
  emulated.time = time;
  emulated.packet_pause_s = kPacketPause_s;
  auto started = emulation::Generator::start(emulated);
  if (!started.ok()) {
    throw std::runtime_error(started.error());
  }
  generator_ = started.take();
  options.port = generator_->port();
  options.plan.boot_s = 0.0;
  options.plan.tolerances.voltage_pu = 0.1;  // 16 384 points
  options.plan.rise_s = 0.05;
  options.plan.margin_s = 0.25;
  options.plan.fall_s = 0.05;
  options.make_safe_s = 0.4;
  // Once in hold(), start() and advance(), which waits from 0.25 to 0.4 s after energise().
  options.check_every_s = 0.15;
}

Abilities GeneratorRig::abilities() const {
  // All commands of a group of settings are sent before the first one is asked back.
  std::size_t largest_group = 0;
  for (const scpi::When when : {scpi::When::kBeforeUpload, scpi::When::kAfterUpload}) {
    std::size_t group = 0;
    for (const scpi::Setting& setting : instrument.settings) {
      group += setting.when == when ? setting.commands.size() : 0;
    }
    largest_group = std::max(largest_group, group);
  }
  const std::size_t most_ahead = instrument.dialect.reset.size() + largest_group + 1;
  return {"\"Maker,Oscilloscope,1,2\" is not", "within 0.3 s", 16, most_ahead, true, true,
          std::chrono::milliseconds(100)};
}

void GeneratorRig::set_answers(Answers answers) {
  emulation::GeneratorFaults faults;
  faults.silent = answers == Answers::kNone;
  faults.half_answers = answers == Answers::kHalf;
  faults.garbage_answers = answers == Answers::kGarbage;
  faults.answer_delay_s = answers == Answers::kSlow      ? 0.01
                          : answers == Answers::kTooSlow ? 1.5 * instrument.timing.answer_s
                                                         : 0.0;
  generator_->set_faults(faults);
}

void GeneratorRig::lose_connection_at(int command) {
  emulation::GeneratorFaults faults;
  faults.drop_at_message = command;
  generator_->set_faults(faults);
}

void GeneratorRig::plug_in() {
  demand(generator_->plug_in());
}

void GeneratorRig::become_another_model() {
  emulation::GeneratorFaults faults;
  faults.identity = "Maker,Oscilloscope,1,2";
  generator_->set_faults(faults);
  // Whoever is connected has to ask again.
  generator_->unplug();
  demand(generator_->plug_in());
}

std::unique_ptr<InstrumentRig> sdg1032x() {
  return std::make_unique<GeneratorRig>(kGeneratorCases[0]);
}
std::unique_ptr<InstrumentRig> sdg2042x() {
  return std::make_unique<GeneratorRig>(kGeneratorCases[1]);
}
std::unique_ptr<InstrumentRig> dg1062z() {
  return std::make_unique<GeneratorRig>(kGeneratorCases[2]);
}
std::unique_ptr<InstrumentRig> k33522b() {
  return std::make_unique<GeneratorRig>(kGeneratorCases[3]);
}

std::string first_error_of_run(source::Source& source, const source::Stimulus& stimulus,
                               const std::function<void(const std::string&)>& before) {
  const auto announce = [&](const char* call) {
    if (before) {
      before(call);
    }
  };
  announce("prepare");
  if (const auto prepared = source.prepare(stimulus); !prepared.ok()) {
    return prepared.error();
  }
  const std::pair<const char*, drivers::Status (source::Source::*)()> calls[] = {
      {"energise", &source::Source::energise},
      {"hold", &source::Source::hold},
      {"start", &source::Source::start}};
  for (const auto& [name, call] : calls) {
    announce(name);
    if (const drivers::Status done = (source.*call)(); !done.ok()) {
      return done.error();
    }
  }
  for (std::int64_t tick = 0; tick < stimulus.total_ticks();) {
    announce("advance");
    const auto played = source.advance(std::min(tick + 400, stimulus.total_ticks()));
    if (!played.ok()) {
      return played.error();
    }
    tick = played.value();
  }
  announce("stop");
  const drivers::Status stopped = source.stop();
  return stopped.ok() ? "" : stopped.error();
}

}  // namespace gsbench::test
