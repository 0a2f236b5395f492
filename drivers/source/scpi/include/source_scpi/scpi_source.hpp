// A waveform generator that speaks SCPI, over TCP or a serial port (Kind::kLoaded). Every setting
// is asked back after it was sent, and about four times a second while the waveform plays.
#pragma once

#include <source_scpi/instrument.hpp>
#include <source_scpi/planner.hpp>

#include <memory>
#include <string>

#include <source/source.hpp>
#include <transport/transport.hpp>

namespace gsbench::scpi {

struct SourceOptions {
  std::string port;  // for transport::make_transport(): "tcp://192.168.1.5:5025", "/dev/ttyUSB0"
  int baud = 115200;
  int channel = 1;
  PlanOptions plan;
  // make_safe() tries for so long to reach an instrument that does not answer, then reports that
  // the state of its output is unknown.
  double make_safe_s = 10.0;
  double check_every_s = 0.25;  // while playing; shorter only for tests
};

// Nothing is opened or sent before prepare() or make_safe(). Calls block: prepare() for the upload,
// about 1 s for each MB and the instrument's pauses; energise() for the rise of the voltage;
// start() until tick 0; stop() and make_safe() until the output is asked to be off, make_safe_s at
// most. make_safe() also works on a source that was never prepared.
std::unique_ptr<source::Source> make_scpi_source(Instrument instrument, SourceOptions options);

}  // namespace gsbench::scpi
