// An emulated waveform generator and sources that drive it, for the suites.
#pragma once

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

class GeneratorRig {
 public:
  explicit GeneratorRig(const GeneratorCase& of, double clock_ppm = 0.0);

  emulation::Generator& generator() { return *generator_; }
  // Another source for the same instrument, as of another bench process.
  std::unique_ptr<source::Source> make_source() const;
  std::unique_ptr<source::Source> make_source(const scpi::Instrument& instrument) const;

  scpi::Instrument instrument;
  scpi::SourceOptions options;

 private:
  std::unique_ptr<emulation::Generator> generator_;
};

// Makes all calls of a run in their order. Returns the first error, or nothing.
std::string first_error_of_run(source::Source& source, const source::Stimulus& stimulus);

}  // namespace gsbench::test
