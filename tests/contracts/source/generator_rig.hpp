// An emulated waveform generator and sources that drive it, for the suites.
#pragma once

#include "instrument_rig.hpp"
#include <source_scpi/scpi_source.hpp>

#include <cstdint>
#include <memory>
#include <string>

#include <emulation/generator.hpp>
#include <source/source.hpp>

namespace gsbench::test {

struct GeneratorCase {
  const char* name;        // of the test: "Sdg2042x"
  const char* instrument;  // the file
  emulation::GeneratorModel model;
};

extern const GeneratorCase kGeneratorCases[4];

// The shipped instrument without the pauses that only hardware needs, and with a short wait for
// answers.
scpi::Instrument quick_instrument(const GeneratorCase& of);

class GeneratorRig : public InstrumentRig {
 public:
  explicit GeneratorRig(const GeneratorCase& of, double clock_ppm = 0.0);

  Abilities abilities() const override;
  std::shared_ptr<source::Source> make_source() override { return make_source(instrument); }
  std::unique_ptr<source::Source> make_source(const scpi::Instrument& altered) const {
    return scpi::make_scpi_source(altered, options);
  }
  bool output_is_on() override { return generator_->output_is_on(); }
  std::size_t commands() override { return generator_->messages().size(); }
  void set_answers(Answers answers) override;
  void lose_connection_at(int command) override;
  void at_command(int command, std::function<void()> then) override {
    generator_->at_message(command, std::move(then));
  }
  void unplug() override { generator_->unplug(); }
  void plug_in() override;
  void reset(std::chrono::milliseconds starting_up) override { generator_->reset_now(starting_up); }
  void become_another_model() override;

  emulation::Generator& generator() { return *generator_; }

  emulation::TrueTime time;
  scpi::Instrument instrument;
  scpi::SourceOptions options;

 private:
  std::unique_ptr<emulation::Generator> generator_;
};

}  // namespace gsbench::test
